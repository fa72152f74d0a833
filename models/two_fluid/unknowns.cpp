#include "two_fluid/unknowns.hpp"

namespace talus::two_fluid {

Unknowns::Unknowns(const Mesh& mesh, Budgets budgets) : g_(&mesh.grid()), budgets_(budgets) {
  const int nx = g_->n_columns(), nz = g_->n_layers();
  for (auto* numbers : {&u_, &w_, &phi_}) numbers->assign(table(nx + 1, 0), -1);
  for (int i = 0; i <= nx; ++i) {
    for (int k = 0; k < nz; ++k) {
      const bool cell = i < nx && mesh.has_cell(i, k);
      if (i < g_->n_faces() && mesh.has_face(i, k)) u_[table(i, k)] = n_fields_++;
      if (!cell) continue;
      if (k > 0 && !mesh.has_cell(i, k - 1)) w_[table(i, k)] = n_fields_++;
      w_[table(i, k + 1)] = n_fields_++;
      phi_[table(i, k)] = n_fields_++;
      ++n_fields_;  // p
    }
  }
}

}  // namespace talus::two_fluid
