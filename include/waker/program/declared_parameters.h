// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_declared_parameters_h
#define waker_program_declared_parameters_h

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  struct Input;

  /// The names that the user gives to subsections.
  struct ParameterNames
  {
    std::vector<std::string> materials;       // Materials/Names
    std::vector<std::string> layers;          // Soil profile/Layers
    std::vector<std::string> conditions;      // Boundary conditions/Names
    std::vector<std::string> head_lines;      // Head lines/Names
    std::vector<std::string> reference_lines; // Reference lines/Names
    std::vector<std::string> tractions;       // Tractions/Names
    std::vector<std::string> point_loads;     // Point loads/Names
    std::vector<std::string> load_programmes; // Load programmes/Names
    std::vector<std::string> walls;           // Walls/Names
    std::vector<std::string> outlets;         // Outflow/Names
    std::vector<std::string> inflows;         // Inflow/Names
    std::vector<std::string> fields;          // Random fields/Names
  };

  /// A section with a list of names and a subsection for each of them.
  struct NamedSection
  {
    std::string              section; // "Soil profile"
    std::string              list;    // "Layers"
    std::vector<std::string> ParameterNames::*names;
  };

  extern const std::vector<NamedSection> named_sections;

  /// A parameter as `prm` knows it.
  struct DeclaredParameter
  {
    std::string section; // "Materials/clay", or empty at the top level
    std::string name;
    std::string value;
    std::string default_value;
    std::string pattern; // deal.II's description, "[Double 0...1 (inclusive)]"
    std::string documentation;

    std::string
    path() const;

    /// Is its value the name of a file that is read? Its pattern says so,
    /// Patterns::FileName(input): then the contents of the file count, not its
    /// name, wherever the parameter decides something.
    bool
    is_input_file() const;
  };

  /**
   * Declare every parameter, in the order in which a reader wants to see
   * them; the lists of names get their values from `names`. `input` gets one
   * material, layer, condition and field per name, and must not move or resize
   * them as long as `prm` sets values.
   */
  void
  declare_parameters(ParameterHandler     &prm,
                     Input                &input,
                     const ParameterNames &names);

  /// What has been declared, in that order, with the values of now.
  std::vector<DeclaredParameter>
  declared_parameters(const ParameterHandler &prm);

  /// Finds parameters and sections by their paths, whatever their number.
  class DeclaredIndex
  {
  public:
    explicit DeclaredIndex(std::vector<DeclaredParameter> parameters);

    /// In the order of their declaration.
    const std::vector<DeclaredParameter> &
    all() const
    {
      return parameters;
    }

    /// @return null if there is none
    const DeclaredParameter *
    find(const std::string &path) const;

    bool
    has_section(const std::string &path) const;

  private:
    std::vector<DeclaredParameter>               parameters;
    std::unordered_map<std::string, std::size_t> places;
    std::unordered_set<std::string>              sections;
  };

  /// A deal.II pattern in words: "a number from 0 to 1", "one of a, b".
  std::string
  pattern_in_words(const std::string &pattern);

  /// The same, with what may be wrong with a value that does not fit: a decimal
  /// comma, a number beyond the range of the program's.
  std::string
  allowed_instead(const std::string &value, const std::string &pattern);

  /// Does the value fit the pattern?
  bool
  matches_pattern(const std::string &value, const std::string &pattern);

  /// A value that fits, in one way of writing: 1e3 and 1000.0 become 1000, so
  /// that the hash of a case depends on values, not on how they are written.
  std::string
  normalised(const std::string &value, const std::string &pattern);
} // namespace Waker

#endif
