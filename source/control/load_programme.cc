// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/control/load_programme.h>

#include <algorithm>

namespace Waker
{
  LoadProgramme::LoadProgramme(const LoadProgrammeParameters &parameters)
    : given(parameters)
    , end(parameters.end_of_growth())
  {
    if (has_table(given.kind))
      table = given.read_table();
  }


  LoadRecord
  LoadProgramme::start() const
  {
    LoadRecord record;
    if (has_table(given.kind))
      record.factor = table.value(0.);
    record.next = record.factor;
    return record;
  }


  void
  LoadProgramme::watch(const LoadWatch &seen, LoadRecord &record) const
  {
    if (!record.is_stopped() && seen.stop > given.stop_above)
      record.stop_time = record.time;
    // A table does not wait, whatever it is told to watch.
    record.held = given.kind == LoadProgrammeKind::growth && !is_over(record) &&
                  record.time >= given.start_time &&
                  seen.hold > given.hold_above;
    if (given.kind == LoadProgrammeKind::table_of_quantity)
      record.next = table.value(seen.table);
  }


  double
  LoadProgramme::factor(const LoadRecord &record, const double time) const
  {
    if (record.is_stopped() || !(time > record.time))
      return record.factor;
    switch (given.kind)
      {
        case LoadProgrammeKind::growth:
          {
            if (record.held || is_over(record))
              return record.factor;
            const double since = std::max(record.time, given.start_time);
            const double grown =
              record.factor + given.rate * std::max(0., time - since);
            return given.rate > 0. ? std::min(grown, end)
                                   : std::max(grown, end);
          }
        case LoadProgrammeKind::table_of_time:
          return table.value(time);
        case LoadProgrammeKind::table_of_quantity:
          return record.next;
      }
    return record.factor;
  }


  void
  LoadProgramme::proceed(const double time, LoadRecord &record) const
  {
    const double before = record.factor;
    record.factor       = factor(record, time);
    if (record.factor != before)
      record.change_time = time;
    if (record.held)
      record.held_for += time - record.time;
    record.time = time;
  }


  bool
  LoadProgramme::is_over(const LoadRecord &record) const
  {
    if (record.is_stopped())
      return true;
    switch (given.kind)
      {
        case LoadProgrammeKind::growth:
          return given.rate > 0. ? record.factor >= end : record.factor <= end;
        case LoadProgrammeKind::table_of_time:
          return record.time >= table.last_change();
        case LoadProgrammeKind::table_of_quantity:
          return false;
      }
    return false;
  }


  double
  LoadProgramme::last_change(const LoadRecord &record) const
  {
    if (record.is_stopped())
      return record.change_time;
    switch (given.kind)
      {
        case LoadProgrammeKind::growth:
          return is_over(record) ? record.change_time : LastChange::unknown;
        case LoadProgrammeKind::table_of_time:
          return table.last_change();
        case LoadProgrammeKind::table_of_quantity:
          return LastChange::never;
      }
    return LastChange::unknown;
  }


  bool
  LoadProgramme::changes_after(const double time) const
  {
    switch (given.kind)
      {
        case LoadProgrammeKind::growth:
        case LoadProgrammeKind::table_of_quantity:
          return false;
        case LoadProgrammeKind::table_of_time:
          return table.last_change() > time;
      }
    return false;
  }
} // namespace Waker
