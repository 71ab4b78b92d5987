// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/output/files.h>
#include <waker/statistics/columns.h>
#include <waker/statistics/field_columns.h>
#include <waker/statistics/results_file.h>
#include <waker/statistics/results_scenarios.h>
#include <waker/store/hdf5_file.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace Waker
{
  namespace
  {
    constexpr std::int32_t schema_version = 1;

    const std::vector<std::string> plane = {"scenario", "realisation"};


    /// Records by their place in the plane of scenario and realisation.
    struct Table
    {
      std::vector<std::int64_t>   realisations; // that occur, ascending
      std::vector<AnalysedRecord> records;
      std::vector<std::size_t>    places; // of each record
      std::size_t                 n_places = 0;
      std::size_t                 n_slides = 1; // at most
      std::size_t                 n_masses = 1; // at most
    };


    const std::vector<SlidingMass> &
    masses_of(const Record &record)
    {
      static const std::vector<SlidingMass> none;
      return record.sliding_masses ? record.sliding_masses->masses : none;
    }


    Table
    make_table(const std::string         &path,
               const CampaignInfo        &info,
               const std::vector<Record> &records,
               const SlideParameters     &slide_parameters)
    {
      Table table;
      for (const Record &record : records)
        {
          if (record.scenario >= info.scenarios.size())
            throw UserError(path,
                            "there is a record of scenario " +
                              std::to_string(record.scenario),
                            "scenarios 0 to " +
                              std::to_string(info.scenarios.size() - 1) +
                              ", those of the campaign");
          table.realisations.push_back(
            static_cast<std::int64_t>(record.realisation));
        }
      auto &numbers = table.realisations;
      std::sort(numbers.begin(), numbers.end());
      numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());

      table.n_places = info.scenarios.size() * numbers.size();
      std::vector<bool> taken(table.n_places, false);
      for (const Record &record : records)
        {
          const auto found =
            std::lower_bound(numbers.begin(),
                             numbers.end(),
                             static_cast<std::int64_t>(record.realisation));
          const std::size_t place =
            record.scenario * numbers.size() +
            static_cast<std::size_t>(found - numbers.begin());
          if (taken[place])
            throw std::logic_error("a realisation occurs twice in a store");
          taken[place] = true;

          std::vector<Slide> slides = find_slides(record, slide_parameters);
          const FailureClass failure_class =
            classify(record,
                     slides,
                     info.scenarios[record.scenario].base_level);
          table.n_slides = std::max(table.n_slides, slides.size());
          table.n_masses = std::max(table.n_masses, masses_of(record).size());
          table.records.push_back({&record, std::move(slides), failure_class});
          table.places.push_back(place);
        }
      return table;
    }


    Hdf5File::Attributes
    describe(const std::string &units, const std::string &long_name)
    {
      return {{"units", units}, {"long_name", long_name}};
    }


    /// What stands where nothing was run or nothing happened.
    template <typename Number>
    constexpr Number missing = std::numeric_limits<Number>::has_quiet_NaN
                                 ? std::numeric_limits<Number>::quiet_NaN()
                                 : static_cast<Number>(-1);


    template <typename Argument, typename Number>
    Hdf5File::Attributes
    describe(const Column<Argument, Number> &column)
    {
      Hdf5File::Attributes attributes =
        describe(column.units, column.long_name);
      attributes.emplace_back("_FillValue", missing<Number>);
      if (!column.flag_meanings.empty())
        {
          std::vector<std::int8_t> values(
            1 + std::count(column.flag_meanings.begin(),
                           column.flag_meanings.end(),
                           ' '));
          std::iota(values.begin(), values.end(), std::int8_t(0));
          attributes.emplace_back("flag_values", values);
          attributes.emplace_back("flag_meanings", column.flag_meanings);
        }
      return attributes;
    }


    template <typename Number>
    void
    write_columns(Hdf5File                                          &file,
                  const Table                                       &table,
                  const std::vector<Column<AnalysedRecord, Number>> &columns)
    {
      for (const auto &column : columns)
        {
          std::vector<Number> values(table.n_places, missing<Number>);
          for (std::size_t i = 0; i < table.records.size(); ++i)
            values[table.places[i]] = column.value(table.records[i]);
          file.write_variable(column.name, plane, values, describe(column));
        }
    }


    /// What there are several of in a realisation.
    /// @param items_of an analysed record, a vector
    template <typename Item, typename Function>
    void
    write_items(Hdf5File                                &file,
                const Table                             &table,
                const std::string                       &dimension,
                const std::size_t                        n_items,
                const std::vector<Column<Item, double>> &columns,
                const Function                          &items_of)
    {
      for (const auto &column : columns)
        {
          std::vector<double> values(table.n_places * n_items, missing<double>);
          for (std::size_t i = 0; i < table.records.size(); ++i)
            {
              const std::vector<Item> &items = items_of(table.records[i]);
              for (std::size_t j = 0; j < items.size(); ++j)
                values[table.places[i] * n_items + j] = column.value(items[j]);
            }
          file.write_variable(column.name,
                              {"scenario", "realisation", dimension},
                              values,
                              describe(column));
        }
    }


    std::string
    make_store(const CampaignInfo        &info,
               const std::vector<Record> &records,
               const Table               &table,
               const SlideParameters     &slides,
               const JournalCounts       &counts,
               const std::uint64_t        n_surplus)
    {
      Hdf5File file;
      file.write_attributes({{"Conventions", "CF-1.8"},
                             {"title", "Waker campaign"},
                             {"schema_version", schema_version},
                             {"version", info.version},
                             {"compiler", info.compiler},
                             {"build_flags", info.build_flags},
                             {"seed", info.seed},
                             {"parameters_hash", info.hash},
                             {"parameters", info.parameters},
                             {"swept_parameter", info.swept_parameter},
                             {"realisations_planned", info.realisations},
                             {"slide_rate", slides.rate},
                             {"slide_duration", slides.duration},
                             {"slide_minimum_change", slides.minimum_change},
                             {"machines", to_json(counts.machines)},
                             {"n_truncated_lines", counts.n_truncated},
                             {"n_damaged_lines", counts.n_damaged},
                             {"n_foreign_lines", counts.n_foreign},
                             {"n_repeated_lines", counts.n_repeated},
                             {"n_conflicting_lines", counts.n_conflicting},
                             {"n_surplus", n_surplus}});

      std::vector<std::int32_t> scenarios(info.scenarios.size());
      std::iota(scenarios.begin(), scenarios.end(), 0);
      const auto write_numbers = [&](const std::string &name,
                                     const std::size_t  n,
                                     const std::string &long_name) {
        std::vector<std::int32_t> numbers(n);
        std::iota(numbers.begin(), numbers.end(), 0);
        file.write_dimension(name, numbers, describe("1", long_name));
      };
      file.write_dimension("scenario",
                           scenarios,
                           describe("1", "number of the scenario"));
      file.write_dimension("realisation",
                           table.realisations,
                           describe("1", "number of the realisation"));
      write_numbers("slide", table.n_slides, "number of the slide");
      write_numbers("mass", table.n_masses, "number of the sliding mass");

      write_scenarios(file, info);
      write_estimates(file, info, records);
      write_columns(file, table, flag_columns);
      write_columns(file, table, count_columns);
      write_columns(file, table, real_columns);
      write_columns(file, table, sliding_columns);
      write_columns(file, table, sliding_count_columns);
      write_columns(file, table, work_columns);
      for (const FieldColumn &column : field_columns({&records}))
        {
          std::vector<double> values(table.n_places, missing<double>);
          for (std::size_t i = 0; i < table.records.size(); ++i)
            values[table.places[i]] = column.value(*table.records[i].record);
          Hdf5File::Attributes attributes =
            describe(column.units, column.long_name);
          attributes.emplace_back("_FillValue", missing<double>);
          file.write_variable(column.name, plane, values, attributes);
        }
      write_items(
        file, table, "slide", table.n_slides, slide_columns, [
        ](const AnalysedRecord &a) -> const auto & { return a.slides; });
      write_items(
        file, table, "mass", table.n_masses, mass_columns, [
        ](const AnalysedRecord &a) -> const auto & {
          return masses_of(*a.record);
        });
      return file.close();
    }
  } // namespace



  void
  write_store(const std::string         &path,
              const CampaignInfo        &info,
              const std::vector<Record> &records,
              const SlideParameters     &slide_parameters,
              const JournalCounts       &counts,
              const std::uint64_t        n_surplus)
  {
    const Table table = make_table(path, info, records, slide_parameters);
    std::string contents;
    try
      {
        contents =
          make_store(info, records, table, slide_parameters, counts, n_surplus);
      }
    catch (const std::runtime_error &error)
      {
        throw UserError(path, error.what(), "enough memory for the whole file");
      }
    write_file(path, contents, true);
  }
} // namespace Waker
