// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/stencil.h>
#include <waker/mechanics/kinematics.h>
#include <waker/mechanics/stress_update.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    /// Scalars per point that fit on the stack; more is a material's mistake.
    constexpr unsigned int max_variables = 16;


    template <int dim>
    inline Tensor<2, dim>
    in_plane(const SymmetricTensor<2, 3> &stress, const double scale)
    {
      Tensor<2, dim> P;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          P[i][j] = scale * stress[i][j];
      return P;
    }


    /// Strains of a block of points, and their stresses turned with them.
    template <int dim>
    void
    move_block(const double (&H)[dim * dim][Material::block_size],
               const bool       objective_rate,
               Material::Block &block)
    {
      if constexpr (dim == 2)
        {
          // Of fixed length and on plain numbers: a few vector instructions.
          const double *const xx = H[0], *const xy = H[1];
          const double *const yx = H[2], *const yy = H[3];
          double *const s_xx  = block.stress[0];
          double *const s_yy  = block.stress[1];
          double *const s_xy  = block.stress[3];
          double *const e_xx  = block.strain_increment[0];
          double *const e_yy  = block.strain_increment[1];
          double *const e_xy  = block.strain_increment[3];
          const double  share = objective_rate ? 1. : 0.;
#pragma GCC ivdep
          for (unsigned int l = 0; l < Material::block_size; ++l)
            {
              double g_xx = xx[l], g_xy = xy[l], g_yx = yx[l], g_yy = yy[l];
              to_mid_step(share, g_xx, g_xy, g_yx, g_yy);
              turn_in_plane(share * 0.5 * (g_xy - g_yx),
                            s_xx[l],
                            s_yy[l],
                            s_xy[l]);
              e_xx[l] = g_xx;
              e_yy[l] = g_yy;
              e_xy[l] = 0.5 * (g_xy + g_yx);
            }
          for (const unsigned int a : {2, 4, 5})
            std::fill_n(block.strain_increment[a], Material::block_size, 0.);
        }
      else
        for (unsigned int l = 0; l < Material::block_size; ++l)
          {
            Tensor<2, dim> gradient;
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                gradient[i][j] = H[dim * i + j][l];
            SymmetricTensor<2, 3> stress;
            for (unsigned int a = 0; a < 6; ++a)
              stress.access_raw_entry(a) = block.stress[a][l];
            const Kinematics<dim>       motion(gradient, objective_rate);
            const SymmetricTensor<2, 3> turned = motion.turn(stress);
            const SymmetricTensor<2, 3> strain = motion.strain();
            for (unsigned int a = 0; a < 6; ++a)
              {
                block.stress[a][l]           = turned.access_raw_entry(a);
                block.strain_increment[a][l] = strain.access_raw_entry(a);
              }
          }
    }


    /// Elastic energy per volume of a stress (kPa).
    inline double
    elastic_energy(const SymmetricTensor<2, 3> &stress,
                   const Material              &material)
    {
      const double p = trace(stress) / 3.;
      return p * p / (2. * material.bulk_modulus()) +
             (stress * stress - 3. * p * p) / (4. * material.shear_modulus());
    }
  } // namespace


  template <int dim>
  void
  declare_material_variables(const Materials     &materials,
                             MaterialPoints<dim> &points)
  {
    for (unsigned int m = 0; m < materials.size(); ++m)
      for (const MaterialVariable &variable : materials[m]->variables())
        {
          std::vector<double> &values = points.scalar(variable.name);
          for (std::size_t p = 0; p < points.n_points(); ++p)
            if (points.material[p] == m)
              values[p] = variable.initial_value;
        }
  }


  template <int dim>
  double
  elastic_energy(const MaterialPoints<dim> &points, const Materials &materials)
  {
    double sum = 0.;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      sum += points.volume[p] *
             elastic_energy(points.stress[p], *materials[points.material[p]]);
    return sum;
  }


  template <int dim>
  StressUpdate<dim>::StressUpdate(const Materials &materials,
                                  const bool       objective_rate)
    : materials(&materials)
    , objective_rate(objective_rate)
    , n_variables(0)
  {
    for (const auto &material : materials)
      n_variables =
        std::max<unsigned int>(n_variables, material->variables().size());
    AssertThrow(n_variables <= max_variables,
                ExcMessage("a material declares too many variables"));
  }


  template <int dim>
  void
  StressUpdate<dim>::find_variables(const MaterialPoints<dim> &points)
  {
    variable_arrays.assign(materials->size(), {});
    for (unsigned int m = 0; m < materials->size(); ++m)
      for (const MaterialVariable &variable : (*materials)[m]->variables())
        {
          const int i = points.find_scalar(variable.name);
          AssertThrow(i >= 0,
                      ExcMessage("the points lack the variable " +
                                 variable.name));
          variable_arrays[m].push_back(i);
        }
    gradients.resize(points.n_points());
    new_stress.resize(points.n_points());
    new_variables.resize(n_variables * points.n_points());
    dissipation.resize(points.n_points());
  }


  template <int dim>
  void
  StressUpdate<dim>::evaluate(const MaterialPoints<dim> &points,
                              const Weights<dim>        &weights,
                              const NodalVector         &increment,
                              NodalVector               &internal_force)
  {
    find_variables(points);
    internal_force = 0.;

    // In blocks of neighbours of one material.
    const std::size_t n     = points.n_points();
    std::size_t       begin = 0;
    while (begin < n)
      {
        const unsigned int m   = points.material[begin];
        std::size_t        end = begin + 1;
        while (end < n && end < begin + Material::block_size &&
               points.material[end] == m)
          ++end;
        evaluate_block(points,
                       weights,
                       begin,
                       end,
                       increment.begin(),
                       internal_force.begin());
        begin = end;
      }
  }


  template <int dim>
  void
  StressUpdate<dim>::evaluate_block(const MaterialPoints<dim> &points,
                                    const Weights<dim>        &weights,
                                    const std::size_t          begin,
                                    const std::size_t          end,
                                    const double              *increment,
                                    double                    *force)
  {
    constexpr unsigned int  N = Material::block_size;
    const Stencil<dim>      stencil(weights.background_grid());
    const unsigned int      m        = points.material[begin];
    const unsigned int      n_points = end - begin;
    const std::vector<int> &arrays   = variable_arrays[m];

    Material::Block block;
    double          variables[max_variables][N];
    double          H[dim * dim][N] = {};
    block.variables                 = variables;

    for (unsigned int l = 0; l < n_points; ++l)
      {
        const std::size_t p = begin + l;
        gradients[p]        = stencil.gradient(weights[p], increment);
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            H[dim * i + j][l] = gradients[p][i][j];
        for (unsigned int a = 0; a < 6; ++a)
          block.stress[a][l] = points.stress[p].access_raw_entry(a);
      }
    for (unsigned int l = n_points; l < N; ++l)
      for (unsigned int a = 0; a < 6; ++a)
        block.stress[a][l] = 0.;
    for (unsigned int v = 0; v < arrays.size(); ++v)
      {
        const double *const values =
          points.scalars[arrays[v]].values.data() + begin;
        for (unsigned int l = 0; l < N; ++l)
          variables[v][l] = l < n_points ? values[l] : 0.;
      }

    move_block<dim>(H, objective_rate, block);
    (*materials)[m]->update_block(n_points, block);

    for (unsigned int l = 0; l < n_points; ++l)
      {
        const std::size_t      p      = begin + l;
        SymmetricTensor<2, 3> &stress = new_stress[p];
        for (unsigned int a = 0; a < 6; ++a)
          stress.access_raw_entry(a) = block.stress[a][l];
        dissipation[p] = block.dissipation[l];
        for (unsigned int v = 0; v < arrays.size(); ++v)
          new_variables[n_variables * p + v] = variables[v][l];
        stencil.scatter_gradient(weights[p],
                                 in_plane<dim>(stress, points.volume[p]),
                                 force);
      }
  }


  template <int dim>
  void
  StressUpdate<dim>::tangents(const MaterialPoints<dim> &points,
                              std::vector<PointTangent> &tangents) const
  {
    SymmetricTensor<4, 3> tangent;
    double                variables[max_variables];
    tangents.resize(points.n_points());
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const unsigned int    m        = points.material[p];
        const Material       &material = *(*materials)[m];
        const Kinematics<dim> motion(gradients[p], objective_rate);
        for (unsigned int v = 0; v < variable_arrays[m].size(); ++v)
          variables[v] = points.scalars[variable_arrays[m][v]].values[p];
        const SymmetricTensor<2, 3> turned = motion.turn(points.stress[p]);
        SymmetricTensor<2, 3>       stress = turned;
        material.update(motion.strain(), stress, variables, &tangent);
        motion.stress_derivative(tangent,
                                 turned,
                                 material.shear_modulus(),
                                 points.volume[p],
                                 tangents[p].A);
      }
  }


  template <int dim>
  void
  StressUpdate<dim>::material_tangents(
    const MaterialPoints<dim>          &points,
    std::vector<SymmetricTensor<4, 3>> &tangents) const
  {
    double variables[max_variables];
    tangents.resize(points.n_points());
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const unsigned int    m = points.material[p];
        const Kinematics<dim> motion(gradients[p], objective_rate);
        for (unsigned int v = 0; v < variable_arrays[m].size(); ++v)
          variables[v] = points.scalars[variable_arrays[m][v]].values[p];
        SymmetricTensor<2, 3> stress = motion.turn(points.stress[p]);
        (*materials)[m]->update(motion.strain(),
                                stress,
                                variables,
                                &tangents[p]);
      }
  }


  template <int dim>
  StressReport
  StressUpdate<dim>::accept(MaterialPoints<dim> &points) const
  {
    StressReport report;
    const int    plastic = points.find_scalar("plastic strain");
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const unsigned int m = points.material[p];
        const double       V = points.volume[p];
        report.work_start +=
          scalar_product(in_plane<dim>(points.stress[p], V), gradients[p]);
        report.work_end +=
          scalar_product(in_plane<dim>(new_stress[p], V), gradients[p]);
        report.dissipation += V * dissipation[p];
        report.elastic_energy +=
          V * elastic_energy(new_stress[p], *(*materials)[m]);

        points.stress[p]        = new_stress[p];
        const double *variables = new_variables.data() + n_variables * p;
        for (unsigned int v = 0; v < variable_arrays[m].size(); ++v)
          {
            const int array = variable_arrays[m][v];
            double   &value = points.scalars[array].values[p];
            if (array == plastic)
              report.plastic_strain += variables[v] - value;
            value = variables[v];
          }
      }
    report.plastic_strain /= std::max<std::size_t>(points.n_points(), 1);
    return report;
  }


  template void
  declare_material_variables(const Materials &, MaterialPoints<2> &);
  template void
  declare_material_variables(const Materials &, MaterialPoints<3> &);
  template double
  elastic_energy(const MaterialPoints<2> &, const Materials &);
  template double
  elastic_energy(const MaterialPoints<3> &, const Materials &);
  template class StressUpdate<2>;
  template class StressUpdate<3>;
} // namespace Waker
