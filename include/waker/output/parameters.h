// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_parameters_h
#define waker_output_parameters_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// Section "Output".
  struct OutputParameters
  {
    std::string directory = "output";
    /// Time between ParaView files (s); 0: none but the first and the last.
    double interval  = 0.25;
    bool   particles = true;
    bool   surface   = true;
    bool   grid      = true;
    bool   top_view  = false;
    /// Time between checkpoints (simulated s); 0: only when interrupted.
    double checkpoint_interval = 1.;

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Output/..."
    void
    check() const;
  };
} // namespace Waker

#endif
