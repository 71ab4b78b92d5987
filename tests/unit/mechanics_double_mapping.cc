// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

#include <waker/materials/von_mises_softening.h>
#include <waker/mechanics/double_mapped_tangent.h>

#include "mapping_lattice.h"
#include "verification_data.h"
#include <gtest/gtest.h>
#include <map>

namespace mechanics_double_mapping
{
  using namespace Waker;

  namespace
  {
    constexpr double h = 0.25;


    /// A body with its double-mapped stiffness, at zero increment.
    template <int dim>
    struct Body
    {
      Body(MaterialPoints<dim>  body_points,
           const ShapeFunctions functions,
           const bool           mean,
           const bool           mixed = false)
        : grid(Lattice::grid<dim>(1.5, h))
        , points(std::move(body_points))
        , weights(grid, functions)
        , tangent(weights)
      {
        materials.push_back(std::make_unique<LinearElastic>(1.5, 1000., 0.3));
        materials.push_back(
          std::make_unique<VonMisesSoftening>(1.5, 500., 0.45, 13., 5., -50.));
        NodalVector u(grid.n_dofs()), force(grid.n_dofs());
        if (mixed)
          {
            // Some points that soften, so that D differs from point to point.
            Lattice::Random random(71);
            for (unsigned int p = 0; p < points.n_points(); ++p)
              points.material[p] = p % 2;
            u = Lattice::linear_field(grid,
                                      random.matrix<dim>(-0.05, 0.05),
                                      Tensor<1, dim>());
          }
        declare_material_variables(materials, points);
        weights.reinit(points);
        MappingParameters mapping;
        mapping.volumetric_strain =
          mean ? VolumetricStrain::b_bar : VolumetricStrain::standard;
        StressUpdate<dim> update(materials, make_small_motion<dim>(mapping));
        update.begin(points, weights);
        update.evaluate(points, weights, u, force);
        tangent.reinit(update, points);
      }

      NodalVector
      multiply(const NodalVector &u) const
      {
        NodalVector f(grid.n_dofs());
        f = 3.; // must not matter
        tangent.vmult(f, u);
        return f;
      }

      BackgroundGrid<dim>      grid;
      MaterialPoints<dim>      points;
      Materials                materials;
      Weights<dim>             weights;
      DoubleMappedTangent<dim> tangent;
    };


    /// D of the elastic material.
    SymmetricTensor<4, 3>
    elastic_tangent()
    {
      SymmetricTensor<4, 3> D;
      SymmetricTensor<2, 3> stress;
      LinearElastic(1.5, 1000., 0.3).update({}, stress, nullptr, &D);
      return D;
    }


    template <int dim>
    SymmetricTensor<2, 3>
    embedded(const SymmetricTensor<2, dim> &strain)
    {
      SymmetricTensor<2, 3> e;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          e[i][j] = strain[i][j];
      return e;
    }


    /// One column of the ordinary Q1 stiffness of a body that fills the grid,
    /// by deal.II.
    /// @param mean dilatation of the cells' centres (B-bar)
    template <int dim>
    NodalVector
    exact_column(const BackgroundGrid<dim> &grid,
                 const unsigned int         dof,
                 const bool                 mean)
    {
      const auto   &fe = grid.dof_handler().get_fe();
      FEValues<dim> values(fe,
                           QGauss<dim>(3),
                           update_gradients | update_JxW_values);
      FEValues<dim> at_centre(fe, QGauss<dim>(1), update_gradients);
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      const FEValuesExtractors::Vector     displacement(0);
      const auto                           D = elastic_tangent();
      NodalVector                          column(grid.n_dofs());
      for (const auto &cell : grid.dof_handler().active_cell_iterators())
        {
          cell->get_dof_indices(dofs);
          const auto found = std::find(dofs.begin(), dofs.end(), dof);
          if (found == dofs.end())
            continue;
          values.reinit(cell);
          at_centre.reinit(cell);
          const auto strain = [&](const unsigned int i, const unsigned int q) {
            auto e = embedded(values[displacement].symmetric_gradient(i, q));
            if (mean)
              e += (at_centre[displacement].divergence(i, 0) -
                    values[displacement].divergence(i, q)) /
                   3. * unit_symmetric_tensor<3>();
            return e;
          };
          const unsigned int j = found - dofs.begin();
          for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
            {
              const auto stress = D * strain(j, q);
              for (unsigned int i = 0; i < dofs.size(); ++i)
                column.begin()[dofs[i]] +=
                  strain(i, q) * stress * values.JxW(q);
            }
        }
      return column;
    }


    /// In full elements the stiffness is the exact one, at any offset.
    template <int dim>
    double
    largest_error(const Point<dim>    &lower,
                  const unsigned int   n,
                  const double         spacing,
                  const ShapeFunctions functions,
                  const bool           mean)
    {
      const Body<dim> body(Lattice::box(lower, n, spacing), functions, mean);
      double          error     = 0.;
      unsigned int    n_columns = 0;
      for (unsigned int i = 0; i < body.grid.n_nodes(); ++i)
        {
          const Point<dim> x    = body.grid.node_position(i);
          bool             full = true; // all elements around the node
          for (unsigned int d = 0; d < dim; ++d)
            full = full && x[d] - h >= lower[d] - 1e-12 &&
                   x[d] + h <= lower[d] + n * spacing + 1e-12;
          if (!full)
            continue;
          for (unsigned int c = 0; c < dim; ++c, ++n_columns)
            {
              NodalVector unit(body.grid.n_dofs());
              unit.begin()[dim * i + c] = 1.;
              NodalVector column        = body.multiply(unit);
              const auto  exact = exact_column(body.grid, dim * i + c, mean);
              column -= exact;
              error =
                std::max(error, column.linfty_norm() / exact.linfty_norm());
            }
        }
      EXPECT_GE(n_columns, dim);
      return error;
    }


    template <int dim>
    void
    check_full(const bool mean)
    {
      Lattice::Random random(81);
      double          worst = 0.;
      for (const unsigned int per_cell : {1, 2, 3})
        for (unsigned int offset = 0; offset < 8; ++offset)
          worst = std::max(worst,
                           largest_error(Point<dim>(random.vector<dim>(0., h)),
                                         4 * per_cell,
                                         h / per_cell,
                                         ShapeFunctions::gimp,
                                         mean));
      EXPECT_LT(worst, 1e-12);
      // DM: points at the sub-cells' centres integrate N exactly if aligned.
      const double linear = largest_error(Point<dim>(random.vector<dim>(h, h)),
                                          6,
                                          h / 2.,
                                          ShapeFunctions::linear,
                                          mean);
      EXPECT_LT(linear, 1e-12);
      Verification::row(
        "tangents_double_mapping",
        "dimension,volumetric strain,DM-G against Q1 at any offset,"
        "DM against Q1 aligned",
        dim,
        mean ? "B-bar" : "standard",
        worst,
        linear);
    }


    /// A linear field has the energy of the volume that is there, however the
    /// elements are filled; rigid motions have none.
    template <int dim>
    void
    check_part_filled(const ShapeFunctions functions, const bool mean)
    {
      Lattice::Random random(91);
      const auto      D = elastic_tangent();
      for (unsigned int trial = 0; trial < 20; ++trial)
        {
          // Half of an element; slivers; any lattice.
          MaterialPoints<dim> points;
          const double        sliver = 1e-9 * h;
          if (trial == 0)
            {
              points =
                Lattice::box(Point<dim>(random.vector<dim>(h, h)), 2, h / 2);
              for (auto &array : {&points.mass, &points.volume})
                for (unsigned int p = 1; p < array->size(); p += 2)
                  (*array)[p] = 0.; // the right half is empty
            }
          else if (trial == 1)
            points = Lattice::box(
              Point<dim>(random.vector<dim>(h + sliver, h + sliver)), 2, h / 2);
          else
            points = Lattice::box(Point<dim>(random.vector<dim>(0., 0.5)),
                                  3,
                                  random(0.2 * h, h));
          double volume = 0.;
          for (const double v : points.volume)
            volume += v;
          const Body<dim>   body(points, functions, mean);
          const auto        A = random.matrix<dim>(-1., 1.);
          const NodalVector u =
            Lattice::linear_field(body.grid, A, random.vector<dim>(-1., 1.));
          const auto   e     = embedded(symmetrize(A));
          const double exact = volume * (e * (D * e));
          EXPECT_NEAR(u * body.multiply(u), exact, 1e-11 * exact) << trial;

          const NodalVector spin =
            Lattice::linear_field(body.grid,
                                  Tensor<2, dim>(A - transpose(A)),
                                  random.vector<dim>(-1., 1.));
          EXPECT_LT(body.multiply(spin).linfty_norm(), 1e-9) << trial;
        }
    }


    template <int dim>
    void
    check_symmetry(const ShapeFunctions functions, const bool mean)
    {
      Lattice::Random random(95);
      const Body<dim> body(
        Lattice::box(Point<dim>(random.vector<dim>(0.2, 0.4)), 4, 0.45 * h),
        functions,
        mean,
        /*mixed=*/true);
      const unsigned int n = body.grid.n_dofs();
      EXPECT_TRUE(body.tangent.is_symmetric());
      NodalVector u(n), v(n);
      for (unsigned int i = 0; i < n; ++i)
        {
          u.begin()[i] = random(-1., 1.);
          v.begin()[i] = random(-1., 1.);
        }
      const double uv = u * body.multiply(v);
      EXPECT_NEAR(uv, v * body.multiply(u), 1e-10 * std::abs(uv));

      NodalVector diagonal(n), unit(n);
      diagonal = -2.;
      body.tangent.add_diagonal(diagonal);
      double largest = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          unit               = 0.;
          unit.begin()[i]    = 1.;
          const double entry = body.multiply(unit).begin()[i];
          ASSERT_NEAR(diagonal.begin()[i] + 2., entry, 1e-10) << i;
          largest = std::max(largest, entry);
        }
      EXPECT_GT(largest, 50.);
    }
  } // namespace


  TEST(Mechanics, double_mapping_is_exact_in_full_elements)
  {
    for (const bool mean : {false, true})
      {
        check_full<2>(mean);
        check_full<3>(mean);
      }
  }


  TEST(Mechanics, double_mapping_counts_the_filled_share)
  {
    for (const auto functions : {ShapeFunctions::gimp, ShapeFunctions::linear})
      for (const bool mean : {false, true})
        {
          check_part_filled<2>(functions, mean);
          check_part_filled<3>(functions, mean);
        }
  }


  TEST(Mechanics, double_mapping_is_symmetric)
  {
    for (const auto functions : {ShapeFunctions::gimp, ShapeFunctions::linear})
      for (const bool mean : {false, true})
        {
          check_symmetry<2>(functions, mean);
          check_symmetry<3>(functions, mean);
        }
  }
} // namespace mechanics_double_mapping
