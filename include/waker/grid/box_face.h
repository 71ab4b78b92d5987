// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_grid_box_face_h
#define waker_grid_box_face_h

namespace Waker
{
  /// Faces of the grid's box: number 2d is the lower, 2d + 1 the upper one in
  /// direction d. y is vertical, back is the lower and front the upper z.
  enum class BoxFace
  {
    left,
    right,
    bottom,
    top,
    back,
    front
  };

  constexpr const char *
  name_of(const BoxFace face)
  {
    switch (face)
      {
        case BoxFace::left:
          return "left";
        case BoxFace::right:
          return "right";
        case BoxFace::bottom:
          return "bottom";
        case BoxFace::top:
          return "top";
        case BoxFace::back:
          return "back";
        case BoxFace::front:
          return "front";
      }
    return nullptr;
  }
} // namespace Waker

#endif
