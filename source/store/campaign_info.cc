// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/hash.h>
#include <waker/base/numbers.h>
#include <waker/output/files.h>
#include <waker/store/campaign_info.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace Waker
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    Json
    json_of(const double value)
    {
      return std::isfinite(value) ? Json(value) : Json(nullptr);
    }


    double
    double_of(const Json &json)
    {
      return json.is_null() ? nan : json.get<double>();
    }


    std::string
    dump(const Json &json, const int indentation)
    {
      return json.dump(indentation, ' ', false, Json::error_handler_t::replace);
    }


    /// Is the checksum right, or may there be none? What lies between the
    /// values, blanks and ends of lines, does not count.
    bool
    has_right_checksum(Json json)
    {
      const auto found = json.find("crc");
      if (found == json.end())
        return json.value("schema_version", 1u) < 2;
      const Json checksum = *found;
      json.erase("crc");
      return checksum == checksum_of_text(dump(json, -1));
    }


    std::string
    to_json(const CampaignInfo &info)
    {
      Json json;
      json["schema_version"]  = info.schema_version;
      json["version"]         = info.version;
      json["compiler"]        = info.compiler;
      json["build_flags"]     = info.build_flags;
      json["seed"]            = info.seed;
      json["realisations"]    = info.realisations;
      json["hash"]            = info.hash;
      json["swept_parameter"] = info.swept_parameter;
      json["scenarios"]       = Json::array();
      for (const ScenarioInfo &scenario : info.scenarios)
        {
          Json entry;
          entry["value"]       = scenario.value;
          entry["water_level"] = json_of(scenario.water_level);
          entry["crest_level"] = json_of(scenario.crest_level);
          entry["base_level"]  = json_of(scenario.base_level);
          entry["scales"]      = Json::array();
          for (const double scale : scenario.scales)
            entry["scales"].push_back(json_of(scale));
          entry["hash"] = scenario.hash;
          json["scenarios"].push_back(entry);
        }
      json["parameters"] = info.parameters;
      // Of text that is not UTF-8 a reader sees the replacement, too.
      json        = Json::parse(dump(json, -1));
      json["crc"] = checksum_of_text(dump(json, -1));
      return dump(json, 2) + "\n";
    }


    CampaignInfo
    from_json(const Json &json)
    {
      CampaignInfo info;
      info.schema_version  = json.at("schema_version").get<unsigned int>();
      info.version         = json.at("version").get<std::string>();
      info.compiler        = json.at("compiler").get<std::string>();
      info.build_flags     = json.at("build_flags").get<std::string>();
      info.seed            = json.at("seed").get<std::uint64_t>();
      info.realisations    = json.at("realisations").get<std::uint64_t>();
      info.hash            = json.at("hash").get<std::string>();
      info.swept_parameter = json.at("swept_parameter").get<std::string>();
      for (const Json &entry : json.at("scenarios"))
        {
          ScenarioInfo scenario;
          scenario.value       = entry.at("value").get<std::string>();
          scenario.water_level = double_of(entry.at("water_level"));
          scenario.crest_level = double_of(entry.at("crest_level"));
          // Earlier versions took it for granted.
          const auto base     = entry.find("base_level");
          scenario.base_level = base == entry.end() ? 0. : double_of(*base);
          for (const Json &scale : entry.at("scales"))
            scenario.scales.push_back(double_of(scale));
          scenario.hash = entry.at("hash").get<std::string>();
          info.scenarios.push_back(scenario);
        }
      info.parameters = json.at("parameters").get<std::string>();
      return info;
    }
  } // namespace



  void
  CampaignInfo::write(const std::string &path) const
  {
    write_file(path, to_json(*this), true);
  }



  CampaignInfo
  CampaignInfo::read(const std::string &path)
  {
    const std::string right = "the campaign.json of a campaign's folder";
    const Json        json  = Json::parse(read_file(path), nullptr, false);
    if (!json.is_object())
      throw UserError(path,
                      "is not JSON: damaged, or of something else",
                      right);

    CampaignInfo info;
    try
      {
        if (!has_right_checksum(json))
          throw UserError(path,
                          "is damaged: its checksum is wrong",
                          right + ", as the program wrote it");
        const unsigned int schema =
          json.at("schema_version").get<unsigned int>();
        if (schema > current_schema_version)
          throw UserError(
            path,
            "has schema version " + std::to_string(schema) +
              ": it was written by a newer version of the program",
            "schema versions up to " + std::to_string(current_schema_version));
        info = from_json(json);
      }
    catch (const Json::exception &error)
      {
        throw UserError(path,
                        std::string("is damaged: ") + error.what(),
                        right);
      }
    if (info.scenarios.empty())
      throw UserError(path, "is damaged: it has no scenario", right);
    return info;
  }



  bool
  CampaignInfo::is_whole(const std::string &path)
  {
    const Json json = Json::parse(read_file(path), nullptr, false);
    try
      {
        return json.is_object() && has_right_checksum(json);
      }
    catch (const Json::exception &)
      {
        return false;
      }
  }
} // namespace Waker
