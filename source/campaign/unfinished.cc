// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/unfinished.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/string.hpp>
#include <cmath>
#include <sstream>
#include <utility>

namespace Waker
{
  namespace
  {
    /// Change of W or H that goes into the trace (m).
    constexpr double trace_resolution = 0.02;

    /// Raised when what is stored changes.
    constexpr unsigned int this_layout = 2;


    template <typename Archive>
    void
    archive_all(Archive     &archive,
                Unfinished  &what,
                unsigned int layout,
                std::string  record)
    {
      archive &layout;
      if (layout != this_layout)
        throw std::runtime_error("another layout");
      archive &record &what.attempt &what.state &what.tracer &what
        .has_seen_slide                                      &what.wall_time;
      what.record = record_from_json(record);
    }
  } // namespace


  void
  Tracer::add(const double time, const DykeGeometry &geometry)
  {
    const TracePoint now{time, geometry.width, geometry.height};
    if (points.empty())
      points.push_back(now);
    else if (std::abs(now.width - points.back().width) > trace_resolution ||
             std::abs(now.height - points.back().height) > trace_resolution)
      {
        if (last.time > points.back().time)
          points.push_back(last);
        points.push_back(now);
      }
    last = now;
  }


  std::vector<TracePoint>
  Tracer::finish()
  {
    if (!points.empty() && last.time > points.back().time)
      points.push_back(last);
    return std::move(points);
  }


  std::string
  Unfinished::write() const
  {
    std::ostringstream bytes;
    {
      boost::archive::binary_oarchive archive(bytes);
      Unfinished                      copy = *this;
      archive_all(archive, copy, this_layout, to_json(record));
    }
    return bytes.str();
  }


  std::optional<Unfinished>
  Unfinished::read(const std::string &bytes)
  {
    if (bytes.empty())
      return {};
    try
      {
        std::istringstream              stream(bytes);
        boost::archive::binary_iarchive archive(stream);
        Unfinished                      result;
        archive_all(archive, result, 0, "");
        return result;
      }
    catch (const std::exception &)
      {
        return {};
      }
  }
} // namespace Waker
