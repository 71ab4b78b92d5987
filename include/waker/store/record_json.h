// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_store_record_json_h
#define waker_store_record_json_h

#include <waker/store/record.h>

#include <boost/functional/hash.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  /// Values that a member of a record can have at all: a line with another one
  /// was damaged on the disk. NaN, "there is no such number", is always
  /// allowed.
  struct PlausibleRange
  {
    double low;
    double high;
  };

  namespace Plausible
  {
    /// m; also of a level, which may be below datum. The earth is not larger.
    constexpr PlausibleRange length     = {-1e8, 1e8};
    constexpr PlausibleRange area       = {0., 1e12};      // m^2
    constexpr PlausibleRange share      = {0., 1. + 1e-6}; // -
    constexpr PlausibleRange duration   = {0., 1e12};      // s
    constexpr PlausibleRange event_time = {-1., 1e12};     // s; -1: never
    constexpr PlausibleRange direction  = {-1., 1.};
    constexpr PlausibleRange strength   = {-1e12, 1e12};   // kPa
    constexpr PlausibleRange count      = {0., 1e15};      // a double holds it
    constexpr PlausibleRange any        = {-1e300, 1e300}; // no number, or many
  } // namespace Plausible


  /**
   * How the members of a Record become JSON and come back. A member of type
   * std::optional is one that the lines of earlier versions lack: it is not
   * written while it is empty, and empty where the line does not have it. A
   * number outside of its range, as of a simulation that exploded, is written
   * as one that is not there: what we write can always be read.
   */
  namespace RecordJson
  {
    using Json = nlohmann::ordered_json;

    Json
    json_of(const double value, const PlausibleRange &range);
    Json
    json_of(const std::uint64_t value, const PlausibleRange &);
    Json
    json_of(const unsigned int value, const PlausibleRange &);
    Json
    json_of(const bool value, const PlausibleRange &);
    Json
    json_of(const std::string &value, const PlausibleRange &);
    Json
    json_of(const Outcome outcome, const PlausibleRange &);
    Json
    json_of(const Unrest &unrest, const PlausibleRange &);
    Json
    json_of(const MovedSoil &soil, const PlausibleRange &);
    Json
    json_of(const SlopeSlide &slide, const PlausibleRange &);
    Json
    json_of(const SlidingMasses &sliding, const PlausibleRange &);
    Json
    json_of(const std::vector<TracePoint> &trace, const PlausibleRange &);
    Json
    json_of(const std::vector<FieldSummary> &fields, const PlausibleRange &);

    /// @throws std::runtime_error with `key` if it is of another kind, or
    /// outside the range
    void
    read(const Json           &json,
         const char           *key,
         const PlausibleRange &range,
         double               &value);
    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         std::vector<FieldSummary> &fields);
    void
    read(const Json           &json,
         const char           *key,
         const PlausibleRange &range,
         std::uint64_t        &value);
    void
    read(const Json           &json,
         const char           *key,
         const PlausibleRange &range,
         unsigned int         &value);
    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         bool &value);
    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         std::string &value);
    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         Outcome &outcome);
    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         Unrest &unrest);
    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         MovedSoil &soil);
    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         SlopeSlide &slide);
    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         SlidingMasses &sliding);
    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         std::vector<TracePoint> &trace);

    /// @throws std::runtime_error: "\"key\" what"
    [[noreturn]] void
    throw_wrong(const char *key, const std::string &what);


    /// Add a member to the object of a line.
    template <typename Member>
    void
    put(Json                 &line,
        const char *const     key,
        const PlausibleRange &range,
        const Member         &member)
    {
      line.push_back({key, json_of(member, range)});
    }


    template <typename Member>
    void
    put(Json                        &line,
        const char *const            key,
        const PlausibleRange        &range,
        const std::optional<Member> &member)
    {
      if (member)
        put(line, key, range, *member);
    }


    /// Get a member from the object of a line.
    template <typename Member>
    void
    take(const Json           &line,
         const char *const     key,
         const PlausibleRange &range,
         Member               &member)
    {
      const auto found = line.find(key);
      if (found == line.end())
        throw_wrong(key, "is missing");
      read(*found, key, range, member);
    }


    template <typename Member>
    void
    take(const Json            &line,
         const char *const      key,
         const PlausibleRange  &range,
         std::optional<Member> &member)
    {
      const auto found = line.find(key);
      member.reset();
      if (found != line.end())
        read(*found, key, range, member.emplace());
    }


    /// The lines of version 0.1 have no slides: their time is then NaN.
    void
    put(Json                 &line,
        const char *const     key,
        const PlausibleRange &range,
        const SlopeSlide     &slide);
    void
    take(const Json           &line,
         const char *const     key,
         const PlausibleRange &range,
         SlopeSlide           &slide);


    /// Of the members that have a value.
    class Hash
    {
    public:
      template <typename Value>
      void
      add(const Value &value)
      {
        boost::hash_combine(state, value);
      }

      void
      add(const Unrest &unrest);

      void
      add(const MovedSoil &soil);

      void
      add(const SlopeSlide &slide);

      void
      add(const SlidingMasses &sliding);

      void
      add(const std::vector<FieldSummary> &fields);

      void
      add(const std::vector<TracePoint> &trace);

      template <typename Value>
      void
      add(const std::optional<Value> &value)
      {
        if (value)
          add(*value);
      }

      std::size_t state = 0;
    };
  } // namespace RecordJson
} // namespace Waker

#endif
