#include <Eigen/Core>
#include <algorithm>
#include <complex>
#include <utility>

#include "methods/linear_flow/stops.hpp"
#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/sparse/sparse_products.hpp"

namespace signorini {

namespace {

// Rigid stops on a structure with the springs of compliant ones.
class MixedStops final : public Stops {
 public:
  MixedStops(const FlowStructure& structure, std::vector<bool> rigid)
      : Stops(structure, std::move(rigid)),
        hard_(Stops::on(structure, std::vector<bool>(this->rigid().size(), true))),
        soft_(Stops::on(structure, std::vector<bool>(this->rigid().size(), false))) {}

  void add_acceleration(const ContactMode& mode, double time, const Eigen::Ref<const Eigen::VectorXd>& u,
                        const Eigen::Ref<const Eigen::VectorXd>& v,
                        Eigen::Ref<Eigen::VectorXd> a) const override {
    soft_->add_acceleration(part(mode, false), time, u, v, a);
    if (const ContactMode held = part(mode, true); !held.active.empty())
      hard_->add_acceleration(held, time, u, v, a);
  }

  void relax(const ContactMode& mode, double time, const Eigen::Ref<const Eigen::VectorXd>& u,
             const Eigen::Ref<const Eigen::VectorXd>& v, Eigen::Ref<Eigen::VectorXd> rate) const override {
    soft_->relax(part(mode, false), time, u, v, rate);
  }

  void differentiate(const ContactMode& mode, double time, int k, Eigen::VectorXd load,
                     MotionDerivatives& motion) const override {
    soft_->differentiate(part(mode, false), time, k, std::move(load), motion);
    const ContactMode held = part(mode, true);
    if (held.active.empty()) return;
    auto next = motion.u.col(k + 2).head(structure_.size());
    const Eigen::VectorXd lambda =
        negative_image(held.response, image_by_transposed_columns(structure_.directions, held.active, next));
    next += image_by_columns(structure_.velocity_per_impulse, held.active, lambda);
    for (std::size_t i = 0; i < held.active.size(); ++i)
      motion.lambda(held.active[i], k) = lambda[static_cast<Eigen::Index>(i)];
  }

  [[nodiscard]] Eigen::MatrixXd stiffness(const ContactMode& mode) const override {
    return soft_->stiffness(part(mode, false));
  }
  [[nodiscard]] Eigen::MatrixXd damping(const ContactMode& mode) const override {
    return soft_->damping(part(mode, false));
  }
  void constrain(const ContactMode& mode, Eigen::MatrixXd& from_u, Eigen::MatrixXd& from_v) const override {
    if (const ContactMode held = part(mode, true); !held.active.empty())
      hard_->constrain(held, from_u, from_v);
  }
  [[nodiscard]] double fastest_rate(const ContactMode& mode, double rate) const override {
    return soft_->fastest_rate(part(mode, false), rate);
  }

  // As of rigid stops alone, of the structure that the compliant ones leave.
  [[nodiscard]] FreeForm free_form(const ContactMode& mode) const override {
    const ContactMode pushing = part(mode, false), held = part(mode, true);
    FreeForm form = soft_->free_form(pushing);
    if (mode.active.empty()) return form;
    const int n = structure_.size();
    const auto active = static_cast<Eigen::Index>(mode.active.size());
    Eigen::MatrixXd of_state = Eigen::MatrixXd::Zero(active, structure_.states());
    Eigen::MatrixXcd of_load = Eigen::MatrixXcd::Zero(active, structure_.load.cols());
    if (!held.active.empty()) {
      const Eigen::MatrixXd W = columns_of(structure_.directions, held.active);
      const PivotedQr qr(W);
      form.basis = qr.basis(n).rightCols(n - qr.rank());
      form.offset = least_norm_solve(W.transpose(), entries_of(structure_.gaps, held.active));
      // lambda_A = -G_AA^-1 W_A^T M^-1 (f - K u - D u')
      const Eigen::MatrixXd back =
          product_by_transposed(held.response, columns_of(structure_.velocity_per_impulse, held.active));
      const Eigen::MatrixXd of_u = product(back, form.stiffness), of_v = product(back, form.damping);
      const Eigen::MatrixXcd of_f = product_of_complex(-back, form.load);
      for (std::size_t k = 0; k < held.active.size(); ++k) {
        const Eigen::Index row = place(mode, held.active[k]), from = static_cast<Eigen::Index>(k);
        of_state.row(row).head(n) = of_u.row(from);
        of_state.row(row).tail(n) = of_v.row(from);
        of_load.row(row) = of_f.row(from);
      }
      // The offset bends the springs, too.
      const Eigen::VectorXd bent = form.stiffness * form.offset - structure_.stiffness * form.offset;
      form.load.col(0) -= bent.cast<std::complex<double>>();
    }
    for (std::size_t k = 0; k < pushing.active.size(); ++k) {
      const Eigen::Index row = place(mode, pushing.active[k]), from = static_cast<Eigen::Index>(k);
      of_state.row(row) = form.force_of_state.row(from);
      of_load.row(row) = form.force_of_load.row(from);
    }
    form.force_of_state = std::move(of_state);
    form.force_of_load = std::move(of_load);
    return form;
  }

 private:
  static Eigen::Index place(const ContactMode& mode, int contact) {
    return std::ranges::lower_bound(mode.active, contact) - mode.active.begin();
  }
  // The closed contacts of one kind; their response is theirs alone.
  [[nodiscard]] ContactMode part(const ContactMode& mode, bool rigid) const {
    ContactMode result;
    std::vector<int> rows;
    for (std::size_t k = 0; k < mode.active.size(); ++k) {
      if (this->rigid(mode.active[k]) != rigid) continue;
      result.active.push_back(mode.active[k]);
      rows.push_back(static_cast<int>(k));
    }
    if (!rows.empty()) result.response = block_of(mode.response, rows, rows);
    return result;
  }

  std::unique_ptr<const Stops> hard_, soft_;
};

}  // namespace

std::unique_ptr<const Stops> Stops::mixed_on(const FlowStructure& structure, const std::vector<bool>& rigid) {
  return std::make_unique<MixedStops>(structure, rigid);
}

}  // namespace signorini
