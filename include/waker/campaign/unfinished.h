// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_unfinished_h
#define waker_campaign_unfinished_h

#include <waker/store/record.h>

#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  /// Keeps the geometry where it changes: the moment before a change, and the
  /// one after.
  class Tracer
  {
  public:
    void
    add(const double time, const DykeGeometry &geometry);

    /// All of it, with the last moment; then it is empty.
    std::vector<TracePoint>
    finish();

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      std::size_t n = points.size();
      archive    &n;
      points.resize(n);
      for (TracePoint &point : points)
        archive &point.time &point.width &point.height;
      archive &last.time &last.width &last.height;
    }

  private:
    std::vector<TracePoint> points;
    TracePoint              last{};
  };


  /// A realisation between two steps: all that is needed to go on with it, with
  /// the same result to the last bit.
  struct Unfinished
  {
    unsigned int attempt = 0;
    std::string  state;  // State::write()
    Record       record; // what is known of it
    Tracer       tracer;
    bool         has_seen_slide = false;
    double       wall_time      = 0.; // spent on it so far, s

    std::string
    write() const;

    /// @return nothing if the bytes are not those of this version
    static std::optional<Unfinished>
    read(const std::string &bytes);
  };
} // namespace Waker

#endif
