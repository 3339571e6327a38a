#include <Eigen/Core>
#include <algorithm>
#include <utility>

#include "methods/linear_flow/stops.hpp"
#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/sparse/sparse_products.hpp"

namespace signorini {

namespace {

// Rigid stops, on a structure with the springs of the others where some are compliant.
class RigidStops final : public Stops {
 public:
  RigidStops(const FlowStructure& structure, const std::vector<bool>& rigid) : Stops(structure, rigid) {
    if (mixed()) others_ = Stops::on(structure, std::vector<bool>(rigid.size(), false));
  }

  void add_acceleration(const ContactMode& mode, double time, const Eigen::Ref<const Eigen::VectorXd>& u,
                        const Eigen::Ref<const Eigen::VectorXd>& v,
                        Eigen::Ref<Eigen::VectorXd> a) const override {
    if (!others_) {
      hold(mode, a);
      return;
    }
    others_->add_acceleration(part(mode, false), time, u, v, a);
    hold(part(mode, true), a);
  }

  void relax(const ContactMode& mode, double time, const Eigen::Ref<const Eigen::VectorXd>& u,
             const Eigen::Ref<const Eigen::VectorXd>& v, Eigen::Ref<Eigen::VectorXd> rate) const override {
    if (others_) others_->relax(part(mode, false), time, u, v, rate);
  }

  void differentiate(const ContactMode& mode, double time, int k, Eigen::VectorXd load,
                     MotionDerivatives& motion) const override {
    if (others_) {
      others_->differentiate(part(mode, false), time, k, std::move(load), motion);
    } else {
      motion.x.col(k) = structure_.unloaded(time, motion.u.col(k), k);
      motion.u.col(k + 2) = structure_.factors->solve(load);
    }
    const ContactMode own = others_ ? part(mode, true) : ContactMode{};
    const ContactMode& held = others_ ? own : mode;
    const Eigen::VectorXd lambda = hold(held, motion.u.col(k + 2).head(structure_.size()));
    for (std::size_t i = 0; i < held.active.size(); ++i)
      motion.lambda(held.active[i], k) = lambda[static_cast<Eigen::Index>(i)];
  }

  // The rate of lambda follows from u''', which takes the acceleration with the stops' own forces.
  void forces(const ContactMode& mode, double time, const State& state, Eigen::VectorXd& x,
              Eigen::VectorXd& rate, Eigen::VectorXd& force, Eigen::VectorXd& force_rate) const override {
    if (others_ || !mode.active.empty()) return Stops::forces(mode, time, state, x, rate, force, force_rate);
    x = structure_.unloaded(time, state.u, 0);
    rate = structure_.unloaded(time, state.v, 1);
    force = force_rate = Eigen::VectorXd::Zero(structure_.contact_count());
  }

  [[nodiscard]] Eigen::MatrixXd stiffness(const ContactMode& mode) const override {
    return others_ ? others_->stiffness(part(mode, false)) : Stops::stiffness(mode);
  }
  [[nodiscard]] Eigen::MatrixXd damping(const ContactMode& mode) const override {
    return others_ ? others_->damping(part(mode, false)) : Stops::damping(mode);
  }
  [[nodiscard]] double fastest_rate(const ContactMode& mode, double rate) const override {
    return others_ ? others_->fastest_rate(part(mode, false), rate) : rate;
  }

  // dv/dt -> (I - M^-1 W_A G_AA^-1 W_A^T) dv/dt: what accelerates a held contact is taken away.
  void constrain(const ContactMode& mode, Eigen::MatrixXd& from_u, Eigen::MatrixXd& from_v) const override {
    const ContactMode held = part(mode, true);
    if (held.active.empty()) return;
    const Eigen::MatrixXd W = columns_of(structure_.directions, held.active);
    const Eigen::MatrixXd back =
        product(columns_of(structure_.velocity_per_impulse, held.active), held.response);
    from_u -= product(back, product_of_transposed(W, from_u));
    from_v -= product(back, product_of_transposed(W, from_v));
  }

  // The constraint is removed, not penalised: W_A^T u = g_A is met by u_g, W_A^T Q = 0 by every q. So the
  // double eigenvalue zero that x_A'' = 0 has in the coordinates u is gone.
  [[nodiscard]] FreeForm free_form(const ContactMode& mode) const override {
    const ContactMode held = part(mode, true), pushing = others_ ? part(mode, false) : ContactMode{};
    FreeForm form = others_ ? others_->free_form(pushing) : open_form();
    if (held.active.empty()) return form;
    const int n = structure_.size();
    const auto active = static_cast<Eigen::Index>(mode.active.size());
    const Eigen::MatrixXd W = columns_of(structure_.directions, held.active);
    const PivotedQr qr(W);
    form.basis = qr.basis(n).rightCols(n - qr.rank());
    form.offset = least_norm_solve(W.transpose(), entries_of(structure_.gaps, held.active));
    // lambda_A = -G_AA^-1 W_A^T M^-1 (f - K u - D u')
    const Eigen::MatrixXd back =
        product_by_transposed(held.response, columns_of(structure_.velocity_per_impulse, held.active));
    Eigen::MatrixXd of_state = Eigen::MatrixXd::Zero(active, structure_.states()),
                    held_rows = Eigen::MatrixXd::Zero(back.rows(), structure_.states());
    const Eigen::MatrixXd sprung = others_ ? stiffness(mode) : Eigen::MatrixXd();
    held_rows.leftCols(n) = others_ ? product(back, sprung) : product_by_sparse(back, structure_.stiffness);
    held_rows.rightCols(n) =
        others_ ? product(back, damping(mode)) : product_by_sparse(back, structure_.damping);
    Eigen::MatrixXcd of_load(active, structure_.load.cols());
    const auto write = [&](const ContactMode& of, const Eigen::MatrixXd& state,
                           const Eigen::MatrixXcd& load) {
      for (std::size_t k = 0; k < of.active.size(); ++k) {
        const auto row = std::ranges::lower_bound(mode.active, of.active[k]) - mode.active.begin();
        of_state.row(row) = state.row(static_cast<Eigen::Index>(k));
        of_load.row(row) = load.row(static_cast<Eigen::Index>(k));
      }
    };
    write(held, held_rows, product_of_complex(-back, form.load));
    write(pushing, form.force_of_state, form.force_of_load);
    if (others_) {  // the offset bends the springs, too
      const Eigen::VectorXd bent = sprung * form.offset - structure_.stiffness * form.offset;
      form.load.col(0) -= bent.cast<std::complex<double>>();
    }
    form.force_of_state = std::move(of_state);
    form.force_of_load = std::move(of_load);
    return form;
  }

 private:
  // Takes from an acceleration what held contacts do not admit. Returns lambda_A that does it.
  Eigen::VectorXd hold(const ContactMode& held, Eigen::Ref<Eigen::VectorXd> a) const {
    if (held.active.empty()) return {};
    const Eigen::VectorXd lambda =
        negative_image(held.response, image_by_transposed_columns(structure_.directions, held.active, a));
    a += image_by_columns(structure_.velocity_per_impulse, held.active, lambda);
    return lambda;
  }

  std::unique_ptr<const Stops> others_;  // as if the structure had none but compliant ones
};

}  // namespace

std::unique_ptr<const Stops> Stops::rigid_on(const FlowStructure& structure, const std::vector<bool>& rigid) {
  return std::make_unique<RigidStops>(structure, rigid);
}

}  // namespace signorini
