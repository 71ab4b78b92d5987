// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_level_ground_h
#define waker_tests_level_ground_h

#include "output_temporary_folder.h"
#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

/// Level ground of layers on a firm base, between rollers: the text of a
/// parameter file.
namespace LevelGround
{
  struct Layer
  {
    std::string name, material;
    double      bottom, top; // m
  };

  /// The grid begins at x = 0.
  struct Ground
  {
    double             width = 2., top = 5.; // of the grid, m
    std::vector<Layer> layers;
    std::string        materials;                    // section Materials
    std::string        more;                         // sections after these
    double             cell_size = 0.5, bottom = 0.; // of the grid, m
  };

  /// Settings "path=value", of which new ones replace those of the same path.
  inline std::vector<std::string>
  with(std::vector<std::string>        settings,
       const std::vector<std::string> &new_ones)
  {
    for (const std::string &setting : new_ones)
      {
        const std::string path = setting.substr(0, setting.find('=') + 1);
        settings.erase(std::remove_if(settings.begin(),
                                      settings.end(),
                                      [&](const std::string &other) {
                                        return other.rfind(path, 0) == 0;
                                      }),
                       settings.end());
        settings.push_back(setting);
      }
    return settings;
  }


  inline std::string
  text_of(const Ground &ground)
  {
    std::ostringstream text;
    text << "subsection Grid\n  set Lower corner = 0, " << ground.bottom
         << "\n  set Upper corner = " << ground.width << ", " << ground.top
         << "\n  set Cell size    = " << ground.cell_size << "\nend\n"
         << ground.materials << "subsection Soil profile\n  set Layers = ";
    for (std::size_t l = 0; l < ground.layers.size(); ++l)
      text << (l > 0 ? ", " : "") << ground.layers[l].name;
    for (const Layer &layer : ground.layers)
      text << "\n  subsection " << layer.name
           << "\n    set Material = " << layer.material
           << "\n    set Polygon  = 0, " << layer.bottom << "; " << ground.width
           << ", " << layer.bottom << "; " << ground.width << ", " << layer.top
           << "; 0, " << layer.top << "\n  end";
    text << R"(
end
subsection Boundary conditions
  set Names = base, left side, right side
  subsection base
    set Region = bottom
    set Type   = fixed
  end
  subsection left side
    set Region = left
    set Type   = roller
  end
  subsection right side
    set Region = right
    set Type   = roller
  end
end
)" << ground.more;
    return text.str();
  }

  /// Writes a text to a file of this process. @return its path
  inline std::string
  written(const std::string &text)
  {
    return Waker::put_for_process("level_ground.prm", text);
  }
} // namespace LevelGround

#endif
