// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/hash.h>
#include <waker/base/host.h>
#include <waker/store/journal.h>
#include <waker/store/journal_header.h>

#include <nlohmann/json.hpp>

namespace Waker
{
  namespace
  {
    /// A value that earlier versions did not write.
    template <typename T>
    T
    value_of(const nlohmann::json &header,
             const char *const     name,
             const T              &otherwise)
    {
      const auto found = header.find(name);
      if (found == header.end())
        return otherwise;
      try
        {
          return found->get<T>();
        }
      catch (const nlohmann::json::exception &)
        {
          return otherwise; // no reason to lose the records
        }
    }


    MachineUse
    use_of(const nlohmann::json &header)
    {
      const Machine unknown;
      MachineUse    use;
      use.machine    = {value_of(header, "host", unknown.host),
                        value_of(header, "processor", unknown.processor),
                        value_of(header, "cores", unknown.n_cores),
                        value_of(header, "version", unknown.version),
                        value_of(header, "compiler", unknown.compiler),
                        value_of(header, "build_flags", unknown.build_flags)};
      use.start      = value_of(header, "start", std::string("unknown"));
      use.n_journals = 1;
      return use;
    }
  } // namespace



  std::string
  journal_header_line(const std::string &campaign_hash)
  {
    using Json = nlohmann::ordered_json;

    const Machine machine = this_machine();
    const Json    header  = {{"schema_version", journal_schema_version},
                             {"campaign", campaign_hash},
                             {"version", machine.version},
                             {"compiler", machine.compiler},
                             {"build_flags", machine.build_flags},
                             {"host", machine.host},
                             {"processor", machine.processor},
                             {"cores", machine.n_cores},
                             {"start", utc_time()}};
    // A host may have any name.
    return sealed(header.dump(-1, ' ', false, Json::error_handler_t::replace),
                  "");
  }



  JournalHeader
  read_journal_header(const std::string &line)
  {
    const Seal    seal = check_seal(line, "");
    JournalHeader header;
    header.use           = use_of(nlohmann::json::object());
    header.has_checksums = seal == Seal::whole;
    try
      {
        const nlohmann::json json = nlohmann::json::parse(line);
        header.campaign           = json.at("campaign").get<std::string>();
        header.schema_version = json.at("schema_version").get<unsigned int>();
        header.use            = use_of(json);
        // Version 1 has no checksum; later ones may do without it again.
        header.damaged = seal == Seal::broken ||
                         (seal == Seal::none && header.schema_version == 2);
      }
    catch (const nlohmann::json::exception &)
      {
        header.damaged = true;
      }
    return header;
  }
} // namespace Waker
