// SPDX-License-Identifier: LGPL-2.1-or-later
// A material of the user's own: linear elastic, but it carries no more mean
// tension than 1 kPa. And mistakes in input, which a program can catch.
#include <waker/base/expression.h>
#include <waker/case/case.h>
#include <waker/materials/linear_elastic.h>
#include <waker/particles/material_points.h>
#include <waker/program/parameter_reader.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>

class TensionCap : public Waker::LinearElastic
{
public:
  using LinearElastic::LinearElastic;

  double
  update(const dealii::SymmetricTensor<2, 3> &strain_increment,
         dealii::SymmetricTensor<2, 3>       &stress,
         double                              *variables,
         dealii::SymmetricTensor<4, 3>       *tangent) const override
  {
    LinearElastic::update(strain_increment, stress, variables, tangent);
    const auto   one    = dealii::unit_symmetric_tensor<3>();
    const double excess = trace(stress) / 3. - cap;
    if (excess <= 0.)
      return 0.;
    stress -= excess * one;
    if (tangent != nullptr)
      *tangent -= bulk_modulus() * dealii::outer_product(one, one);
    return cap * excess / bulk_modulus(); // cap times plastic volume strain
  }

  static constexpr double cap = 1.; // kPa
};


/// Does it throw what every program can catch?
bool
throws(const std::function<void()> &mistake)
{
  try
    {
      mistake();
    }
  catch (const std::exception &error)
    {
      std::printf("caught: %s\n", error.what());
      return true;
    }
  return false;
}


/// Without MPI: nobody has started it here.
bool
mistakes_can_be_caught()
{
  bool good = true;
  for (const char *const text : {"1; 2", "0,25", "rand()", "sin(", "", "1e400"})
    good = throws([&]() { Waker::Expression<2>(text, "A/B"); }) && good;
  good = throws([]() { Waker::read_parameters("no.prm", {}); }) && good;

  std::ofstream("consumer.prm")
    << "subsection Grid\n set Lower corner = 0, 0\n"
       " set Upper corner = 2, 2\n set Cell size = 1\nend\n"
       "subsection Materials\n set Names = clay\n subsection clay\n end\nend\n"
       "subsection Soil profile\n set Layers = clay\n subsection clay\n"
       " set Material = clay\n set Polygon = 0,0; 2,0; 2,1; 0,1\n end\nend\n"
       "subsection Boundary conditions\n set Names = base\n subsection base\n"
       " set Region = bottom\n end\nend\n";
  auto                 parameters = Waker::read_parameters("consumer.prm", {});
  const Waker::Case<2> the_case(*parameters, MPI_COMM_SELF);
  const Waker::MaterialPoints<2> &points = the_case.initial_points;
  good = points.scalar("undrained shear strength").size() == 8 && good;
  good = throws([&]() { points.scalar("colour"); }) && good;

  parameters->grid.upper_corner = {2.5, 2.};
  good = throws([&]() { Waker::Case<2>(*parameters, MPI_COMM_SELF); }) && good;
  parameters->layers[0].material = "peat";
  parameters->grid.upper_corner  = {2., 2.};
  return throws([&]() { Waker::Case<2>(*parameters, MPI_COMM_SELF); }) && good;
}


int
main()
{
  if (!mistakes_can_be_caught())
    {
      std::printf("a mistake could not be caught\n");
      return 1;
    }

  const TensionCap                    soil(1.5, 1000., 0.25);
  const dealii::SymmetricTensor<2, 3> stretch =
    0.01 * dealii::unit_symmetric_tensor<3>();

  dealii::SymmetricTensor<2, 3> tension, compression;
  dealii::SymmetricTensor<4, 3> tangent;
  const double dissipated = soil.update(stretch, tension, nullptr, &tangent);
  soil.update(-stretch, compression, nullptr, nullptr);

  // K = 2000/3 kPa: 20 kPa without the cap.
  const bool good = std::abs(trace(tension) / 3. - 1.) < 1e-10 &&
                    std::abs(trace(compression) / 3. + 20.) < 1e-10 &&
                    std::abs(dissipated - 0.0285) < 1e-10 &&
                    (tangent * stretch).norm() < 1e-10;
  std::printf("mean stress: %g kPa in tension, %g kPa in compression: %s\n",
              trace(tension) / 3.,
              trace(compression) / 3.,
              good ? "as expected" : "WRONG");
  return good ? 0 : 1;
}
