// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/read_file.h>
#include <waker/base/stl.h>
#include <waker/base/text.h>
#include <waker/surface/user_surface.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace Waker
{
  namespace
  {
    const char *const allowed_2d =
      "lines with \"x y\" (m), the last vertex of a chain the same as its "
      "first, empty lines between chains, # before comments";


    /// The chain is whole: give its vertices to the surface.
    void
    close_chain(const std::vector<Point<2>> &chain,
                const std::string           &file,
                const std::string           &path,
                UserSurface<2>              &surface)
    {
      if (chain.empty())
        return;
      std::ostringstream start, end;
      start << chain.front();
      end << chain.back();
      if (chain.size() < 2 || chain.front() != chain.back())
        throw UserError(path,
                        "a chain in \"" + file + "\" is open: it starts at (" +
                          start.str() + ") m and ends at (" + end.str() + ") m",
                        allowed_2d);
      const unsigned int n = chain.size() - 1;
      if (n < 3)
        throw UserError(path,
                        "a chain in \"" + file + "\" has " + std::to_string(n) +
                          " different vertices",
                        "at least three");
      const unsigned int first = surface.vertices.size();
      for (unsigned int k = 0; k < n; ++k)
        {
          if (chain[k] == chain[k + 1])
            {
              std::ostringstream where;
              where << chain[k];
              throw UserError(path,
                              "\"" + file + "\" has the vertex (" +
                                where.str() + ") m twice in a row",
                              allowed_2d);
            }
          surface.vertices.push_back(chain[k]);
          surface.elements.push_back({{first + k, first + (k + 1) % n}});
        }
    }


    UserSurface<2>
    parse(const std::string &text,
          const std::string &file,
          const std::string &path,
          const std::integral_constant<int, 2>)
    {
      UserSurface<2>        surface;
      std::vector<Point<2>> chain;
      std::istringstream    stream(text);
      std::string           line;
      for (unsigned int number = 1; std::getline(stream, line); ++number)
        {
          const bool has_comment = line.find('#') != std::string::npos;
          line                   = tidy(line.substr(0, line.find('#')));
          if (line.empty())
            {
              // A line of nothing but a comment parts no chain.
              if (!has_comment)
                {
                  close_chain(chain, file, path, surface);
                  chain.clear();
                }
              continue;
            }
          std::string spaced = line;
          std::replace(spaced.begin(), spaced.end(), ',', ' ');
          const std::vector<std::string> numbers = split(tidy(spaced), ' ');
          Point<2>                       x;
          if (numbers.size() != 2 || !read_number(numbers[0], x[0]) ||
              !read_number(numbers[1], x[1]))
            throw UserError(path,
                            "line " + std::to_string(number) + " of \"" + file +
                              "\" is no vertex: " + in_quotes(line),
                            std::string(allowed_2d) + decimals_with_a_point);
          chain.push_back(x);
        }
      close_chain(chain, file, path, surface);
      return surface;
    }


    /// Triangles with vertices of their own become ones that share them.
    UserSurface<3>
    merge_vertices(const std::vector<StlTriangle> &triangles)
    {
      // STL repeats a vertex in every triangle, digit by digit.
      UserSurface<3>                                surface;
      std::map<std::array<double, 3>, unsigned int> numbers;
      for (const auto &triangle : triangles)
        {
          std::array<unsigned int, 3> element;
          for (unsigned int k = 0; k < 3; ++k)
            {
              const Point<3>             &x = triangle[k];
              const std::array<double, 3> key{{x[0], x[1], x[2]}};
              const auto [entry, is_new] =
                numbers.insert({key, surface.vertices.size()});
              if (is_new)
                surface.vertices.push_back(x);
              element[k] = entry->second;
            }
          // A triangle without extent joins nothing.
          if (element[0] != element[1] && element[1] != element[2] &&
              element[2] != element[0])
            surface.elements.push_back(element);
        }
      return surface;
    }


    UserSurface<3>
    parse(const std::string &text,
          const std::string &file,
          const std::string &path,
          const std::integral_constant<int, 3>)
    {
      return merge_vertices(parse_stl(text, file, path));
    }
  } // namespace


  template <int dim>
  UserSurface<dim>
  read_user_surface(const std::string         &file,
                    const std::string         &path,
                    const BackgroundGrid<dim> &grid)
  {
    const UserSurface<dim> surface =
      parse(read_named_file(file, path, "the surface that is loaded"),
            file,
            path,
            std::integral_constant<int, dim>());
    check_user_surface(surface, "\"" + file + "\"", path, grid);
    return surface;
  }


  template UserSurface<2>
  read_user_surface<2>(const std::string &,
                       const std::string &,
                       const BackgroundGrid<2> &);
  template UserSurface<3>
  read_user_surface<3>(const std::string &,
                       const std::string &,
                       const BackgroundGrid<3> &);
} // namespace Waker
