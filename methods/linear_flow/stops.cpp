#include "methods/linear_flow/stops.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>

#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/sparse/sparse_products.hpp"

namespace signorini {

bool ContactMode::closed(int contact) const {
  return std::binary_search(active.begin(), active.end(), contact);
}

Stops::Stops(const FlowStructure& structure, std::vector<bool> rigid)
    : structure_(structure), rigid_(std::move(rigid)) {
  const bool any = std::ranges::find(rigid_, true) != rigid_.end();
  mixed_ = any && std::ranges::find(rigid_, false) != rigid_.end();
  coupling_ = any ? structure_.delassus : structure_.compliance;
  for (int j = 0; mixed_ && j < structure_.contact_count(); ++j) {
    for (int i = 0; i < structure_.contact_count(); ++i)
      if (!this->rigid(i))
        coupling_(i, j) = this->rigid(j) ? 0.0 : structure_.compliance(i, j);
      else if (!this->rigid(j))
        coupling_(i, j) = 0.0;
  }
}

std::vector<int> Stops::places(const std::vector<int>& active, bool rigid) const {
  std::vector<int> result;
  for (std::size_t k = 0; k < active.size(); ++k)
    if (this->rigid(active[k]) == rigid) result.push_back(static_cast<int>(k));
  return result;
}

ContactMode Stops::part(const ContactMode& mode, bool rigid) const {
  const std::vector<int> rows = places(mode.active, rigid);
  if (rows.size() == mode.active.size()) return mode;
  ContactMode result;
  for (const int k : rows) result.active.push_back(mode.active[static_cast<std::size_t>(k)]);
  if (!rows.empty()) result.response = block_of(mode.response, rows, rows);
  return result;
}

MotionDerivatives Stops::derivatives(const ContactMode& mode, double time, const State& state,
                                     int order) const {
  MotionDerivatives motion{.u = Eigen::MatrixXd::Zero(structure_.positions(), order + 1),
                           .x = Eigen::MatrixXd::Zero(structure_.contact_count(), order - 1),
                           .lambda = Eigen::MatrixXd::Zero(structure_.contact_count(), order - 1)};
  motion.u.col(0) = state.u;
  motion.u.col(1).head(structure_.size()) = state.v;
  // M u^(k+2) = (f - K u - D u')^(k) + W lambda^(k): each derivative gives the next but one.
  for (int k = 0; k + 2 <= order; ++k)
    differentiate(mode, time, k, structure_.free_force(time, motion.u, k), motion);
  return motion;
}

void Stops::forces(const ContactMode& mode, double time, const State& state, Eigen::VectorXd& x,
                   Eigen::VectorXd& rate, Eigen::VectorXd& force, Eigen::VectorXd& force_rate) const {
  const MotionDerivatives motion = derivatives(mode, time, state, 3);
  x = motion.x.col(0);
  rate = motion.x.col(1);
  force = motion.lambda.col(0);
  force_rate = motion.lambda.col(1);
}

FreeForm Stops::open_form() const {
  const int n = structure_.size();
  return {
      .basis = Eigen::MatrixXd::Identity(n, n), .offset = Eigen::VectorXd::Zero(n), .load = structure_.load};
}

namespace {

using Complex = std::complex<double>;

// Writes the forces of the closed contacts A among those of all.
void set_forces(const ContactMode& mode, const Eigen::VectorXd& of_closed, Eigen::Ref<Eigen::VectorXd> all) {
  for (std::size_t i = 0; i < mode.active.size(); ++i)
    all[mode.active[i]] = of_closed[static_cast<Eigen::Index>(i)];
}

std::vector<bool> none_rigid(const FlowStructure& structure) {
  return std::vector<bool>(static_cast<std::size_t>(structure.contact_count()), false);
}

class CompliantStops final : public Stops {
 public:
  explicit CompliantStops(const FlowStructure& structure) : Stops(structure, none_rigid(structure)) {}

  void add_acceleration(const ContactMode& mode, double time, const Eigen::Ref<const Eigen::VectorXd>& u,
                        const Eigen::Ref<const Eigen::VectorXd>&,
                        Eigen::Ref<Eigen::VectorXd> a) const override {
    const Eigen::VectorXd lambda = force(mode, structure_.unloaded(time, u, 0), 0);
    for (const int j : mode.active) a += lambda[j] * structure_.velocity_per_impulse.col(j);
  }

  void differentiate(const ContactMode& mode, double time, int k, Eigen::VectorXd load,
                     MotionDerivatives& motion) const override {
    motion.x.col(k) = structure_.unloaded(time, motion.u.col(k), k);
    motion.lambda.col(k) = force(mode, motion.x.col(k), k);
    motion.x.col(k) += image(structure_.massless_compliance, motion.lambda.col(k));
    load += image(structure_.directions, motion.lambda.col(k));
    motion.u.col(k + 2) = structure_.factors->solve(load);
  }

  void forces(const ContactMode& mode, double time, const State& state, Eigen::VectorXd& x,
              Eigen::VectorXd& rate, Eigen::VectorXd& lambda, Eigen::VectorXd& lambda_rate) const override {
    x = structure_.unloaded(time, state.u, 0);
    rate = structure_.unloaded(time, state.v, 1);
    lambda = force(mode, x, 0);
    lambda_rate = force(mode, rate, 1);
    x += image(structure_.massless_compliance, lambda);
    rate += image(structure_.massless_compliance, lambda_rate);
  }

  [[nodiscard]] Eigen::MatrixXd stiffness(const ContactMode& mode) const override {
    if (mode.active.empty()) return structure_.stiffness;
    const Eigen::MatrixXd active = columns_of(structure_.directions, mode.active);
    return plus_product_by_transposed(structure_.stiffness, product(active, mode.response), active);
  }

  // lambda_A = -C_AA^-1 (W_A^T u + s_A - g_A): a stiffness and a load of the structure.
  [[nodiscard]] FreeForm free_form(const ContactMode& mode) const override {
    FreeForm form = open_form();
    if (mode.active.empty()) return form;
    const int n = structure_.size();
    const Eigen::MatrixXd W = columns_of(structure_.directions, mode.active);
    const Eigen::MatrixXd pull = product(W, mode.response);
    Eigen::MatrixXcd depth = rows_of(structure_.shift, mode.active);
    const Eigen::VectorXd g = entries_of(structure_.gaps, mode.active);
    form.load -= product_of_complex(pull, depth);
    form.load.col(0) += image(pull, g).cast<Complex>();
    form.force_of_state = Eigen::MatrixXd::Zero(mode.response.rows(), 2 * n);
    form.force_of_state.leftCols(n) = product_by_transposed(-mode.response, W);
    depth.col(0) -= g.cast<Complex>();
    form.force_of_load = product_of_complex(-mode.response, depth);
    return form;
  }

  // A mass G_jj^-1 on the spring of its stop alone, sqrt(k G_jj), for each closed contact.
  [[nodiscard]] double fastest_rate(const ContactMode& mode, double rate) const override {
    for (std::size_t i = 0; i < mode.active.size(); ++i) {
      const int j = mode.active[i];
      const auto row = static_cast<Eigen::Index>(i);
      rate = std::hypot(rate, std::sqrt(mode.response(row, row) * structure_.delassus(j, j)));
    }
    return rate;
  }

 private:
  // order-th derivative of lambda from that of W^T u + s, Nc.
  [[nodiscard]] Eigen::VectorXd force(const ContactMode& mode, const Eigen::VectorXd& unloaded,
                                      int order) const {
    Eigen::VectorXd lambda = Eigen::VectorXd::Zero(structure_.contact_count());
    Eigen::VectorXd depth = entries_of(unloaded, mode.active);
    for (Eigen::Index i = 0; i < depth.size() && order == 0; ++i)
      depth[i] -= structure_.gaps[mode.active[static_cast<std::size_t>(i)]];
    set_forces(mode, negative_image(mode.response, depth), lambda);
    return lambda;
  }
};

class RelaxingStops final : public Stops {
 public:
  explicit RelaxingStops(const FlowStructure& structure) : Stops(structure, none_rigid(structure)) {}

  void add_acceleration(const ContactMode& mode, double time, const Eigen::Ref<const Eigen::VectorXd>& u,
                        const Eigen::Ref<const Eigen::VectorXd>& v,
                        Eigen::Ref<Eigen::VectorXd> a) const override {
    const Eigen::VectorXd lambda = force(mode, time, u.head(v.size()), v, 0);
    for (const int j : mode.active) a += lambda[j] * structure_.velocity_per_impulse.col(j);
  }

  void relax(const ContactMode& mode, double time, const Eigen::Ref<const Eigen::VectorXd>& u,
             const Eigen::Ref<const Eigen::VectorXd>& v, Eigen::Ref<Eigen::VectorXd> rate) const override {
    rate = relaxed(time, u.tail(structure_.relaxing()), force(mode, time, u.head(v.size()), v, 0), 0);
  }

  void differentiate(const ContactMode& mode, double time, int k, Eigen::VectorXd load,
                     MotionDerivatives& motion) const override {
    const int n = structure_.size(), r = structure_.relaxing();
    motion.x.col(k) = structure_.unloaded(time, motion.u.col(k), k);
    motion.lambda.col(k) = force(mode, time, motion.u.col(k).head(n), motion.u.col(k + 1).head(n), k);
    motion.u.col(k + 1).tail(r) = relaxed(time, motion.u.col(k).tail(r), motion.lambda.col(k), k);
    load += image(structure_.directions, motion.lambda.col(k));
    motion.u.col(k + 2).head(n) = structure_.factors->solve(load);
  }

  [[nodiscard]] Eigen::MatrixXd stiffness(const ContactMode& mode) const override {
    if (mode.active.empty()) return structure_.stiffness;
    const Eigen::MatrixXd W = columns_of(structure_.directions, mode.active);
    return Eigen::MatrixXd(structure_.stiffness) + product_by_transposed(product(W, mode.response), W);
  }
  [[nodiscard]] Eigen::MatrixXd damping(const ContactMode& mode) const override {
    if (mode.active.empty()) return structure_.damping;
    const Eigen::MatrixXd W = columns_of(structure_.directions, mode.active);
    return Eigen::MatrixXd(structure_.damping) +
           product_by_transposed(product(W, mode.response), times_relaxation(mode, W));
  }

  // A mass G_jj^-1 on the spring and the dashpot of its stop alone.
  [[nodiscard]] double fastest_rate(const ContactMode& mode, double rate) const override {
    for (std::size_t i = 0; i < mode.active.size(); ++i) {
      const int j = mode.active[i];
      const auto row = static_cast<Eigen::Index>(i);
      const double squared = mode.response(row, row) * structure_.delassus(j, j);
      rate = std::hypot(rate, std::sqrt(squared), relaxation(j) * squared);
    }
    return rate;
  }

  // lambda_A = R (g_A - s_A - W_A^T u - B W_A^T v), R = C_AA^-1: springs, dashpots and a load.
  [[nodiscard]] FreeForm free_form(const ContactMode& mode) const override {
    FreeForm form = open_form();
    const int n = structure_.size();
    const auto active = static_cast<Eigen::Index>(mode.active.size());
    const Eigen::MatrixXd W = columns_of(structure_.directions, mode.active);
    const Eigen::VectorXd g = entries_of(structure_.gaps, mode.active);
    const Eigen::MatrixXd response = active > 0 ? mode.response : Eigen::MatrixXd(0, 0);
    Eigen::MatrixXcd depth = rows_of(structure_.shift, mode.active);
    depth.col(0) -= g.cast<Complex>();
    form.force_of_state = Eigen::MatrixXd::Zero(active, structure_.states());
    form.force_of_state.leftCols(n) = product_by_transposed(-response, W);
    form.force_of_state.rightCols(n) = product_by_transposed(-response, times_relaxation(mode, W));
    form.force_of_load = product_in_complex(-response, depth);
    form.load += product_in_complex(W, form.force_of_load);
    form.relaxing = relaxing(mode, W, g, response);
    return form;
  }

 private:
  // beta, 0 of a spring alone.
  [[nodiscard]] double relaxation(int contact) const {
    return structure_.relaxes(contact) ? structure_.relaxation[contact] : 0.0;
  }
  // W_A B, B with beta of each of the closed contacts on its diagonal.
  [[nodiscard]] Eigen::MatrixXd times_relaxation(const ContactMode& mode, Eigen::MatrixXd W) const {
    for (Eigen::Index k = 0; k < W.cols(); ++k)
      W.col(k) *= relaxation(mode.active[static_cast<std::size_t>(k)]);
    return W;
  }

  // order-th derivative of lambda from those of u and v, Nc.
  [[nodiscard]] Eigen::VectorXd force(const ContactMode& mode, double time,
                                      const Eigen::Ref<const Eigen::VectorXd>& u,
                                      const Eigen::Ref<const Eigen::VectorXd>& v, int order) const {
    Eigen::VectorXd lambda = Eigen::VectorXd::Zero(structure_.contact_count());
    if (mode.active.empty()) return lambda;
    const Eigen::VectorXd shift = structure_.shift_at(time, order);
    Eigen::VectorXd depth(static_cast<Eigen::Index>(mode.active.size()));
    for (std::size_t i = 0; i < mode.active.size(); ++i) {
      const int j = mode.active[i];
      const auto w = structure_.directions.col(j);
      depth[static_cast<Eigen::Index>(i)] =
          w.dot(u) + relaxation(j) * w.dot(v) + shift[j] - (order == 0 ? structure_.gaps[j] : 0.0);
    }
    set_forces(mode, negative_image(mode.response, depth), lambda);
    return lambda;
  }

  // The next derivative of xi: beta xi' = s + C lambda - xi.
  [[nodiscard]] Eigen::VectorXd relaxed(double time, const Eigen::Ref<const Eigen::VectorXd>& xi,
                                        const Eigen::VectorXd& lambda, int order) const {
    return (structure_.shift_at(time, order) + image(structure_.massless_compliance, lambda) - xi)
        .cwiseQuotient(structure_.xi_times);
  }

  // xi_A = g_A - W_A^T u, xi_O = z + carried xi_A; 0 where nothing relaxes.
  [[nodiscard]] RelaxingForm relaxing(const ContactMode& mode, const Eigen::MatrixXd& W,
                                      const Eigen::VectorXd& g, const Eigen::MatrixXd& response) const {
    const int contacts = structure_.contact_count();
    std::vector<int> open;
    for (int j = 0; j < contacts; ++j) {
      if (!mode.closed(j) && structure_.relaxes(j)) open.push_back(j);
    }
    const auto count = static_cast<Eigen::Index>(open.size());
    RelaxingForm form{.of_u = Eigen::MatrixXd::Zero(contacts, structure_.size()),
                      .of_z = Eigen::MatrixXd::Zero(contacts, count),
                      .of_xi = Eigen::MatrixXd::Zero(count, contacts),
                      .offset = Eigen::VectorXd::Zero(contacts),
                      .times = entries_of(structure_.xi_times, open)};
    const Eigen::MatrixXd carried =
        product(block_of(structure_.massless_compliance, open, mode.active), response);
    const Eigen::VectorXd offset = image(carried, g);
    set_rows(form.of_u, mode.active, -W.transpose());
    set_rows(form.of_u, open, product_by_transposed(-carried, W));
    for (Eigen::Index k = 0; k < g.size(); ++k) {
      const int j = mode.active[static_cast<std::size_t>(k)];
      if (!structure_.relaxes(j)) {
        form.of_u.row(j).setZero();
        continue;
      }
      form.offset[j] = g[k];
      form.of_xi.col(j) = -carried.col(k);
    }
    for (Eigen::Index i = 0; i < count; ++i) {
      const int j = open[static_cast<std::size_t>(i)];
      form.offset[j] = offset[i];
      form.of_z(j, i) = form.of_xi(i, j) = 1.0;
    }
    form.shift = minus_product_in_complex(rows_of(structure_.shift, open), carried,
                                          rows_of(structure_.shift, mode.active));
    return form;
  }
};

}  // namespace

std::unique_ptr<const Stops> Stops::on(const FlowStructure& structure, const std::vector<bool>& rigid) {
  const bool any = std::ranges::find(rigid, true) != rigid.end();
  if (any || rigid.empty()) return rigid_on(structure, rigid);
  if (structure.relaxing() > 0) return std::make_unique<RelaxingStops>(structure);
  return std::make_unique<CompliantStops>(structure);
}

}  // namespace signorini
