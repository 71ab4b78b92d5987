// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_keeper_h
#define waker_campaign_keeper_h

#include <cstdint>
#include <string>

namespace Waker
{
  /// Keeps what a realisation under way has come to, so that the end of its
  /// process is not the end of it. This one keeps nothing.
  class Keeper
  {
  public:
    virtual ~Keeper() = default;

    /// What a process before this one has kept of the realisation; empty if
    /// there is nothing of use.
    virtual std::string
    earlier()
    {
      return "";
    }

    /// The realisation has come to a moment (s).
    /// @param last it will not come to another one in this process
    /// @return shall it be kept?
    virtual bool
    is_due(const double /*time*/, const bool /*last*/)
    {
      return false;
    }

    /// @param step steps done
    /// @param bytes what earlier() shall give
    virtual void
    keep(const std::uint64_t /*step*/,
         const double /*time*/,
         const std::string & /*bytes*/)
    {}
  };
} // namespace Waker

#endif
