// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/case/case.h>
#include <waker/case/state.h>
#include <waker/loads/water_level.h>
#include <waker/mechanics/energy.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/output/point_arrays.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/stream.hpp>
#include <boost/serialization/binary_object.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace Waker
{
  namespace
  {
    /// Raised when what is stored changes.
    constexpr unsigned int this_layout = 4;


    // Doubles and tensors of doubles: their bytes are their value.
    template <typename Archive, typename T>
    void
    array(Archive &archive, std::vector<T> &values)
    {
      std::size_t n = values.size();
      archive    &n;
      values.resize(n);
      archive &boost::serialization::make_binary_object(values.data(),
                                                        n * sizeof(T));
    }


    /// @param sizes of the points' arrays
    template <int dim, typename Archive>
    void
    all(Archive &archive, std::vector<std::uint64_t> &sizes, State<dim> &state)
    {
      unsigned int layout = this_layout;
      archive     &layout;
      if (layout != this_layout)
        throw std::runtime_error("a state of another layout");
      std::size_t n_scalars = state.points.scalars.size();
      archive    &n_scalars;
      state.points.scalars.resize(n_scalars);
      for (NamedArray &scalar : state.points.scalars)
        archive &scalar.name;
      archive    &sizes;
      std::size_t n_surfaces = state.surface_vertices.size();
      archive    &n_surfaces;
      state.surface_vertices.resize(n_surfaces);
      for (std::vector<Point<dim>> &vertices : state.surface_vertices)
        array(archive, vertices);
      array(archive, state.wall_tractions);
      archive &state.tractions &state.loads &state.settlement_rate &state
        .pore_water;
      archive &state.time &state.step &state.flow &state.energy &state
        .failure &state.sliding &state.rest &state.mean_plastic_strain &state
        .displacement_rate &state.last_dt &state.halvings &state
        .steps_since_change &state.newton_iterations &state
        .linear_iterations &state.unconverged_steps &state.long_steps;
    }
  } // namespace


  template <int dim>
  std::string
  State<dim>::write_record(const std::vector<std::uint64_t> &array_sizes) const
  {
    std::string bytes;
    {
      boost::iostreams::stream<
        boost::iostreams::back_insert_device<std::string>>
                                      stream(bytes);
      boost::archive::binary_oarchive archive(stream);
      // Boost's archives write through references that are not const.
      all(archive,
          const_cast<std::vector<std::uint64_t> &>(array_sizes),
          const_cast<State<dim> &>(*this));
    }
    return bytes;
  }


  template <int dim>
  void
  State<dim>::read_record(const std::string &bytes)
  {
    boost::iostreams::stream<boost::iostreams::array_source> stream(
      bytes.data(), bytes.size());
    boost::archive::binary_iarchive archive(stream);
    std::vector<std::uint64_t>      sizes;
    all(archive, sizes, *this);
    auto size = sizes.begin();
    MaterialPoints<dim>::for_each_array(points, [&](const char *, auto &array) {
      if (size == sizes.end())
        throw std::runtime_error("arrays without a size");
      array.resize(*size++);
    });
  }


  template <int dim>
  std::string
  State<dim>::write() const
  {
    const OwnRows                    all_rows(points.n_points());
    const std::vector<std::uint64_t> sizes  = array_sizes(points, all_rows);
    const std::string                record = write_record(sizes);
    const std::uint64_t              n      = record.size();
    std::string                      bytes; // there once, however many points
    bytes.reserve(sizeof n + n + n_bytes_of_arrays(points, sizes));
    bytes.append(reinterpret_cast<const char *>(&n), sizeof n);
    bytes += record;
    append_arrays(points, bytes);
    return bytes;
  }


  template <int dim>
  void
  State<dim>::read(const std::string &bytes)
  {
    std::uint64_t n = 0;
    if (bytes.size() < sizeof n)
      throw std::runtime_error("no state");
    std::memcpy(&n, bytes.data(), sizeof n);
    if (n > bytes.size() - sizeof n)
      throw std::runtime_error("a state without its end");
    read_record(bytes.substr(sizeof n, n));
    read_arrays(std::string_view(bytes).substr(sizeof n + n), points);
  }


  template <int dim>
  State<dim>
  initial_state(const Case<dim> &the_case, MaterialPoints<dim> points)
  {
    State<dim> state;
    state.points = std::move(points);
    if (the_case.parameters.sliding.watch)
      SlidingMassFinder<dim>::start(state.points);
    state.surface_vertices     = initial_vertices(the_case);
    state.wall_tractions       = the_case.initial_wall_tractions;
    state.energy.kinetic_start = kinetic_energy(state.points);
    state.energy.kinetic       = state.energy.kinetic_start;
    state.energy.elastic_start =
      elastic_energy(state.points, the_case.materials);
    state.energy.elastic = state.energy.elastic_start;
    state.loads          = the_case.programmes.start();
    state.pore_water =
      the_case.pore_water.start(WaterLevel(the_case.parameters.water).at(0.));
    the_case.flow.start(state);
    // Whether what is there at t = 0 is in balance is seen by a short one.
    const TimeParameters &time = the_case.parameters.time;
    state.long_steps.active =
      scheme_traits(time).has_long_steps && state.energy.kinetic_start == 0.;
    if (state.long_steps.active)
      state.halvings = time.maximum_halvings;
    return state;
  }


  template <int dim>
  State<dim>
  initial_state(const Case<dim> &the_case)
  {
    return initial_state(the_case, the_case.initial_points);
  }


  template struct State<2>;
  template struct State<3>;
  template State<2>
  initial_state(const Case<2> &);
  template State<3>
  initial_state(const Case<3> &);
  template State<2>
  initial_state(const Case<2> &, MaterialPoints<2>);
  template State<3>
  initial_state(const Case<3> &, MaterialPoints<3>);
} // namespace Waker
