// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/expression_pattern.h>
#include <waker/campaign/input.h>
#include <waker/program/declared_parameters.h>
#include <waker/program/prm_scanner.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <sstream>
#include <utility>

namespace Waker
{
  namespace
  {
    template <typename Struct>
    void
    declare_section(ParameterHandler  &prm,
                    const std::string &section,
                    Struct            &parameters)
    {
      prm.enter_subsection(section);
      parameters.add_parameters(prm);
      prm.leave_subsection();
    }


    /// A section with a list of names and a subsection for each.
    template <typename Struct>
    void
    declare_named(ParameterHandler               &prm,
                  const std::string              &section,
                  const std::string              &list,
                  const std::string              &documentation,
                  const std::vector<std::string> &names,
                  std::vector<Struct>            &parameters)
    {
      prm.enter_subsection(section);
      prm.declare_entry(list, "", Patterns::Anything(), documentation);
      std::string joined;
      for (const std::string &name : names)
        joined += (joined.empty() ? "" : ", ") + name;
      prm.set(list, joined);

      parameters.resize(names.size());
      for (std::size_t i = 0; i < names.size(); ++i)
        {
          parameters[i].name = names[i];
          declare_section(prm, names[i], parameters[i]);
        }
      prm.leave_subsection();
    }


    using Tree = boost::property_tree::ptree;


    /// deal.II writes all but letters and digits of a name as "_" and the
    /// number of the byte. Only its XML keeps that: in its JSON a point in a
    /// name makes two sections of one.
    std::string
    demangled(const std::string &name)
    {
      std::string result;
      for (std::size_t i = 0; i < name.size(); ++i)
        if (name[i] == '_' && i + 2 < name.size())
          {
            result += static_cast<char>(
              std::stoi(name.substr(i + 1, 2), nullptr, /* base = */ 16));
            i += 2;
          }
        else
          result += name[i];
      return result;
    }


    /// Collect the leaves of deal.II's tree.
    void
    collect(const Tree                     &node,
            const std::string              &section,
            std::vector<DeclaredParameter> &result)
    {
      const auto text = [](const Tree &leaf, const char *const key) {
        return leaf.get<std::string>(key, "");
      };
      for (const auto &[key, child] : node)
        if (child.find("pattern_description") == child.not_found())
          collect(child, parameter_path(section, demangled(key)), result);
        else
          result.push_back({section,
                            demangled(key),
                            tidy(text(child, "value")),
                            tidy(text(child, "default_value")),
                            text(child, "pattern_description"),
                            text(child, "documentation")});
    }
  } // namespace


  const std::vector<NamedSection> named_sections = {
    {"Materials", "Names", &ParameterNames::materials},
    {"Soil profile", "Layers", &ParameterNames::layers},
    {"Boundary conditions", "Names", &ParameterNames::conditions},
    {"Head lines", "Names", &ParameterNames::head_lines},
    {"Reference lines", "Names", &ParameterNames::reference_lines},
    {"Tractions", "Names", &ParameterNames::tractions},
    {"Point loads", "Names", &ParameterNames::point_loads},
    {"Load programmes", "Names", &ParameterNames::load_programmes},
    {"Walls", "Names", &ParameterNames::walls},
    {"Outflow", "Names", &ParameterNames::outlets},
    {"Inflow", "Names", &ParameterNames::inflows},
    {"Random fields", "Names", &ParameterNames::fields}};


  std::string
  DeclaredParameter::path() const
  {
    return parameter_path(section, name);
  }


  bool
  DeclaredParameter::is_input_file() const
  {
    const auto input = Patterns::FileName(Patterns::FileName::input);
    return pattern == input.description();
  }


  void
  declare_parameters(ParameterHandler     &prm,
                     Input                &input,
                     const ParameterNames &names)
  {
    Parameters            &parameters  = input.simulation;
    ReliabilityParameters &reliability = input.reliability;
    prm.add_parameter("Dimension",
                      parameters.dimension,
                      "2: plane strain, per metre. 3: layers are extruded "
                      "along z.",
                      Patterns::Integer(2, 3));
    prm.add_parameter("Cross-section",
                      parameters.cross_section,
                      "z (m) of a section through a case of three dimensions, "
                      "which is computed instead of it, in plane strain, with "
                      "its random fields as they are there; or none. It meets "
                      "what begins at z or below and ends above. With --set, "
                      "and Output/Directory without, that gets \"-section-\" "
                      "and z at its end.",
                      NumberOrWordPattern("none"));
    declare_section(prm, "Grid", parameters.grid);
    declare_section(prm, "Material points", parameters.points);
    declare_named(prm,
                  "Materials",
                  "Names",
                  "Names of the materials, separated by commas; each has a "
                  "subsection.",
                  names.materials,
                  parameters.materials);
    declare_named(prm,
                  "Soil profile",
                  "Layers",
                  "Names of the layers, separated by commas; each has a "
                  "subsection.",
                  names.layers,
                  parameters.layers);
    declare_named(prm,
                  "Boundary conditions",
                  "Names",
                  "Names of the boundary conditions, separated by commas; "
                  "each has a subsection.",
                  names.conditions,
                  parameters.fixities);
    declare_section(prm, "Gravity", parameters.gravity);
    declare_section(prm, "Initial stress", parameters.initial_stress);
    declare_section(prm, "Water", parameters.water);
    declare_section(prm, "Pore water", parameters.pore_water);
    const auto named = [&](const std::string              &section,
                           const std::string              &what,
                           const std::vector<std::string> &of_section,
                           auto                           &structs) {
      declare_named(prm,
                    section,
                    "Names",
                    "Names of the " + what +
                      ", separated by commas; each has a subsection.",
                    of_section,
                    structs);
    };
    named("Head lines",
          "head lines",
          names.head_lines,
          parameters.pore_water.head_lines);
    named("Reference lines",
          "reference lines",
          names.reference_lines,
          parameters.pore_water.reference_lines);
    declare_section(prm, "Surface", parameters.surface);
    named("Tractions", "tractions", names.tractions, parameters.tractions);
    named("Point loads",
          "point loads",
          names.point_loads,
          parameters.point_loads);
    named("Load programmes",
          "load programmes",
          names.load_programmes,
          parameters.load_programmes);
    named("Walls", "walls", names.walls, parameters.walls);
    declare_section(prm, "Outflow", parameters.outflow);
    declare_named(prm,
                  "Outflow",
                  "Names",
                  "Names of the parts of faces through which soil leaves, "
                  "separated by commas; each has a subsection.",
                  names.outlets,
                  parameters.outlets);
    named("Inflow", "inflows", names.inflows, parameters.inflows);
    declare_section(prm, "Kinematics and mapping", parameters.mapping);
    declare_section(prm, "Time stepping", parameters.time);
    declare_section(prm, "Newton", parameters.newton);
    declare_section(prm, "Initial failure", parameters.initial_failure);
    declare_section(prm, "Sliding masses", parameters.sliding);
    declare_section(prm, "Stop rules", parameters.stop);
    declare_section(prm, "Strength reduction", parameters.strength_reduction);
    declare_section(prm, "Ranks", parameters.ranks);
    declare_named(prm,
                  "Random fields",
                  "Names",
                  "Names of the random fields, separated by commas; each has a "
                  "subsection. Empty: nothing is random.",
                  names.fields,
                  reliability.fields.fields);
    declare_section(prm, "Random fields", reliability.fields);
    declare_section(prm, "Campaign", reliability.campaign);
    declare_section(prm, "Sweep", reliability.sweep);
    declare_section(prm, "Snapshots", reliability.snapshots);
    reliability.analysis.add_parameters(prm);
    declare_section(prm, "Output", parameters.output);
  }


  std::vector<DeclaredParameter>
  declared_parameters(const ParameterHandler &prm)
  {
    std::stringstream text;
    prm.print_parameters(text,
                         ParameterHandler::XML |
                           ParameterHandler::KeepDeclarationOrder);
    Tree tree;
    boost::property_tree::read_xml(text, tree);
    std::vector<DeclaredParameter> result;
    collect(tree.get_child("ParameterHandler"), "", result);
    return result;
  }


  DeclaredIndex::DeclaredIndex(std::vector<DeclaredParameter> given)
    : parameters(std::move(given))
  {
    for (std::size_t i = 0; i < parameters.size(); ++i)
      {
        places.emplace(parameters[i].path(), i);
        // With all sections above it.
        std::string section = parameters[i].section;
        while (!section.empty() && sections.insert(section).second)
          {
            const std::size_t slash = section.rfind('/');
            section.resize(slash == std::string::npos ? 0 : slash);
          }
      }
  }


  const DeclaredParameter *
  DeclaredIndex::find(const std::string &path) const
  {
    const auto found = places.find(path);
    return found == places.end() ? nullptr : &parameters[found->second];
  }


  bool
  DeclaredIndex::has_section(const std::string &path) const
  {
    return sections.count(path) != 0;
  }
} // namespace Waker
