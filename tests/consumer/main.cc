// SPDX-License-Identifier: LGPL-2.1-or-later
// A material of the user's own: linear elastic, but it carries no more mean
// tension than 1 kPa.
#include <waker/materials/linear_elastic.h>

#include <cmath>
#include <cstdio>

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


int
main()
{
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
