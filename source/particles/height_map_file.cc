// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/read_file.h>
#include <waker/base/text.h>
#include <waker/particles/height_map.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    using Place = std::array<double, 3>; // x, z, y


    bool
    is_stl(const std::string &file)
    {
      std::string end =
        file.substr(file.size() - std::min<std::size_t>(4, file.size()));
      for (char &c : end)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      return end == ".stl";
    }


    std::string
    place_of(const Place &place)
    {
      return "(x, z) = (" + in_digits(place[0]) + ", " + in_digits(place[1]) +
             ") m";
    }


    /// Throws UserErrors about one table.
    class Table
    {
    public:
      Table(const std::string &name, const std::string &path)
        : name(name)
        , path(path)
      {}

      /// The places, by z, then x.
      std::vector<Place>
      read(const std::string &text) const
      {
        std::vector<Place>      places;
        std::array<unsigned, 3> columns{};
        bool                    has_titles = false;
        std::istringstream      stream(text);
        std::string             line;
        for (unsigned int number = 1; std::getline(stream, line); ++number)
          {
            line = tidy(line.substr(0, line.find('#')));
            if (line.empty())
              continue;
            const std::vector<std::string> items = split(line, ',');
            if (!has_titles)
              {
                columns    = columns_of(items, line);
                has_titles = true;
                continue;
              }
            Place place{};
            bool  good = items.size() == 3;
            for (unsigned int k = 0; good && k < 3; ++k)
              good = read_number(items[columns[k]], place[k]);
            if (!good)
              refuse("has no place and height in line " +
                     std::to_string(number) + ": " + in_quotes(line));
            places.push_back(place);
          }
        if (places.empty())
          refuse("has no places");
        std::sort(places.begin(),
                  places.end(),
                  [](const Place &a, const Place &b) {
                    return a[1] < b[1] || (a[1] == b[1] && a[0] < b[0]);
                  });
        return places;
      }

      /// The coordinates of the grid's lines in direction d (0: x, 1: z).
      std::vector<double>
      lines(const std::vector<Place> &places, const unsigned int d) const
      {
        std::vector<double> x;
        for (const Place &place : places)
          x.push_back(place[d]);
        std::sort(x.begin(), x.end());
        x.erase(std::unique(x.begin(), x.end()), x.end());
        if (x.size() < 2)
          refuse(std::string("has only one ") + (d == 0 ? "x" : "z"));
        return x;
      }

      /// Is there each place of the grid, and once?
      void
      check_grid(const std::vector<Place>  &places,
                 const std::vector<double> &x,
                 const std::vector<double> &z) const
      {
        for (std::size_t p = 0; p + 1 < places.size(); ++p)
          if (places[p][0] == places[p + 1][0] &&
              places[p][1] == places[p + 1][1])
            refuse("has two heights at " + place_of(places[p]) + ", " +
                   in_digits(places[p][2]) + " and " +
                   in_digits(places[p + 1][2]) + " m");
        // Of the grid's places the first that is not the next of the list.
        std::size_t p = 0;
        for (const double z_k : z)
          for (const double x_i : x)
            {
              if (p == places.size() || places[p][0] != x_i ||
                  places[p][1] != z_k)
                refuse("has a hole: no height at " +
                       place_of({{x_i, z_k, 0.}}));
              ++p;
            }
      }

    private:
      /// Where x, z and y stand. "x (m)" is an x.
      std::array<unsigned, 3>
      columns_of(const std::vector<std::string> &titles,
                 const std::string              &line) const
      {
        std::array<unsigned, 3> columns{};
        unsigned int            found = 0;
        for (unsigned int c = 0; c < titles.size(); ++c)
          for (unsigned int k = 0; k < 3; ++k)
            {
              const std::string title = tidy(titles[c]);
              if (title == std::string(1, "xzy"[k]) ||
                  title == std::string(1, "xzy"[k]) + " (m)")
                {
                  columns[k] = c;
                  found |= 1u << k;
                }
            }
        if (titles.size() != 3 || found != 7u)
          refuse("begins with " + in_quotes(line) +
                 " instead of the names of three columns");
        return columns;
      }

      [[noreturn]] void
      refuse(const std::string &what) const
      {
        throw UserError(path,
                        name + " " + what,
                        std::string("an STL file (*.stl), or a table whose "
                                    "first line is \"x, z, y\" and whose "
                                    "places are those of a rectangular grid, "
                                    "each once") +
                          decimals_with_a_point);
      }

      std::string name;
      std::string path;
    };


    std::vector<StlTriangle>
    triangles_of_table(const std::string &text, const Table &table)
    {
      const std::vector<Place>  places = table.read(text);
      const std::vector<double> x      = table.lines(places, 0);
      const std::vector<double> z      = table.lines(places, 1);
      table.check_grid(places, x, z);
      const auto vertex = [&](const std::size_t i, const std::size_t k) {
        const Place &place = places[k * x.size() + i];
        return dealii::Point<3>(place[0], place[2], place[1]);
      };
      std::vector<StlTriangle> triangles;
      for (std::size_t k = 0; k + 1 < z.size(); ++k)
        for (std::size_t i = 0; i + 1 < x.size(); ++i)
          {
            const std::array<dealii::Point<3>, 4> corners = {
              {vertex(i, k),
               vertex(i + 1, k),
               vertex(i + 1, k + 1),
               vertex(i, k + 1)}};
            dealii::Point<3> middle;
            for (const auto &corner : corners)
              middle += corner / 4.;
            for (unsigned int c = 0; c < 4; ++c)
              triangles.push_back({{corners[c], corners[(c + 1) % 4], middle}});
          }
      return triangles;
    }
  } // namespace


  std::shared_ptr<const HeightMap>
  read_height_map(const std::string           &file,
                  const std::array<double, 2> &lower,
                  const std::array<double, 2> &upper,
                  const double                 round_off,
                  const std::string           &path)
  {
    const std::string text =
      read_named_file(file, path, "the heights that bound the layer");
    const std::string name = "\"" + file + "\"";
    return std::make_shared<HeightMap>(
      is_stl(file) ? parse_stl(text, file, path)
                   : triangles_of_table(text, Table(name, path)),
      lower,
      upper,
      round_off,
      name,
      path);
  }
} // namespace Waker
