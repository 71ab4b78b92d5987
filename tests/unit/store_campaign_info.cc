// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/store/campaign_info.h>

#include "output_temporary_folder.h"
#include "store_records.h"
#include <gtest/gtest.h>

namespace Waker::store_campaign_info
{
  TEST(Store, campaign_info_returns_from_its_file)
  {
    const TemporaryFolder folder;
    const std::string     path   = folder.file("campaign.json");
    CampaignInfo          info   = synthetic_campaign();
    info.scenarios[0].scales     = {1. / 3., 0.5, 7.};
    info.scenarios[0].base_level = -6.;
    info.write(path);

    const CampaignInfo copy = CampaignInfo::read(path);
    EXPECT_EQ(copy.schema_version, info.schema_version);
    EXPECT_EQ(copy.version, info.version);
    EXPECT_EQ(copy.compiler, info.compiler);
    EXPECT_EQ(copy.build_flags, info.build_flags);
    EXPECT_EQ(copy.seed, info.seed);
    EXPECT_EQ(copy.realisations, info.realisations);
    EXPECT_EQ(copy.hash, info.hash);
    EXPECT_EQ(copy.swept_parameter, info.swept_parameter);
    EXPECT_EQ(copy.parameters, info.parameters);
    ASSERT_EQ(copy.scenarios.size(), 2u);
    for (const unsigned int k : {0, 1})
      {
        EXPECT_EQ(copy.scenarios[k].value, info.scenarios[k].value);
        EXPECT_EQ(copy.scenarios[k].water_level, info.scenarios[k].water_level);
        EXPECT_EQ(copy.scenarios[k].crest_level, info.scenarios[k].crest_level);
        EXPECT_EQ(copy.scenarios[k].base_level, info.scenarios[k].base_level);
        EXPECT_EQ(copy.scenarios[k].scales, info.scenarios[k].scales);
        EXPECT_EQ(copy.scenarios[k].hash, info.scenarios[k].hash);
      }
  }


  TEST(Store, campaign_info_refuses_what_is_none)
  {
    const TemporaryFolder folder;
    const std::string     path    = folder.file("campaign.json");
    const auto            problem = [&]() -> std::string {
      try
        {
          CampaignInfo::read(path);
        }
      catch (const UserError &error)
        {
          EXPECT_EQ(error.where, path);
          return error.problem;
        }
      return "";
    };
    EXPECT_EQ(problem(), "cannot be read: No such file or directory");

    synthetic_campaign().write(path);
    const std::string good = get(path);
    EXPECT_EQ(problem(), "");
    put(path, good.substr(0, good.size() / 2));
    EXPECT_EQ(problem(), "is not JSON: damaged, or of something else");
    for (const auto &[from, to] :
         std::vector<std::pair<std::string, std::string>>{
           {"\"seed\"", "\"need\""},
           {"\"water_level\": 4.5", "\"water_level\": 5.5"},
           {"\"schema_version\": 2", "\"schema_version\": 3"},
           {"\"schema_version\": 2", "\"schema_version\": 0"},
           {"\"crc\"", "\"csc\""}})
      {
        put(path, replaced(good, from, to));
        EXPECT_EQ(problem(), "is damaged: its checksum is wrong") << to;
      }
    // How the values are laid out does not matter.
    put(path, replaced(good, "\n  \"seed\"", "\n\"seed\""));
    EXPECT_EQ(problem(), "");

    // An earlier version wrote no checksum, a later one writes what it likes.
    const auto without = [&](const std::string &version) {
      std::string       text = replaced(good, "\"schema_version\": 2", version);
      const std::size_t at   = text.find(",\n  \"crc\"");
      return text.substr(0, at) + "}";
    };
    put(path, without("\"schema_version\": 1"));
    EXPECT_EQ(problem(), "");
    put(path, replaced(without("\"schema_version\": 1"), "\"seed\"", "\"x\""));
    EXPECT_NE(problem().find("'seed' not found"), std::string::npos)
      << problem();
    CampaignInfo later   = synthetic_campaign();
    later.schema_version = 3;
    later.write(path);
    EXPECT_NE(problem().find("newer version"), std::string::npos) << problem();

    CampaignInfo empty = synthetic_campaign();
    empty.scenarios.clear();
    empty.write(path);
    EXPECT_EQ(problem(), "is damaged: it has no scenario");
  }
} // namespace Waker::store_campaign_info
