// A method in a shared object that misbehaves while it is asked for a solution: option deed says how.

#include <sys/resource.h>
#include <unistd.h>

#include <cfenv>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <thread>

#include "methods/plugin/plugin.hpp"

namespace attack {

enum class Deed {
  stand_still,
  segv,
  abort,
  exit_0,
  quick_exit,
  throw_int,
  throw_long_text,
  recurse,
  loop,
  hog,
  threads,
  children,
  close_all,
  close_and_loop,
  flood_pipes,
  upward,
  flush_to_zero,
  handlers,
  ignore_term,
  long_message,
  raw_message,
  null_motion,
  nan_motion,
  throwing_motion,
  looping_motion,
  wrong_size,
  huge_period,
  zero_the_problem,
  free_twice,
  smash_heap,
  stop_itself,
  kill_group
};

}  // namespace attack

namespace signorini {
template <>
struct EnumNames<attack::Deed> {
  static constexpr std::array<std::string_view, 32> values{"stand-still",
                                                           "segv",
                                                           "abort",
                                                           "exit-0",
                                                           "quick-exit",
                                                           "throw-int",
                                                           "throw-long-text",
                                                           "recurse",
                                                           "loop",
                                                           "hog",
                                                           "threads",
                                                           "children",
                                                           "close-all",
                                                           "close-and-loop",
                                                           "flood-pipes",
                                                           "upward",
                                                           "flush-to-zero",
                                                           "handlers",
                                                           "ignore-term",
                                                           "long-message",
                                                           "raw-message",
                                                           "null-motion",
                                                           "nan-motion",
                                                           "throwing-motion",
                                                           "looping-motion",
                                                           "wrong-size",
                                                           "huge-period",
                                                           "zero-the-problem",
                                                           "free-twice",
                                                           "smash-heap",
                                                           "stop-itself",
                                                           "kill-group"};
};
}  // namespace signorini

namespace attack {

/// What is at rest, or else what the deed makes of it.
class Motion final : public signorini::Trajectory {
 public:
  Motion(const signorini::Problem& problem, Deed deed)
      : contacts_(problem.contact_count()), period_(problem.period()), deed_(deed) {}
  [[nodiscard]] int contact_count() const override { return contacts_; }
  [[nodiscard]] double period() const override {
    return deed_ == Deed::huge_period ? 1e9 * period_ : period_;
  }
  [[nodiscard]] signorini::Samples sample(int count) const override {
    if (deed_ == Deed::throwing_motion) throw 7;
    while (deed_ == Deed::looping_motion) pause();
    const double value = deed_ == Deed::nan_motion ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    const Eigen::Index rows = deed_ == Deed::wrong_size ? count / 2 : count;
    const Eigen::MatrixXd at_rest = Eigen::MatrixXd::Constant(rows, contacts_, value);
    return {at_rest, at_rest, at_rest};
  }

 private:
  int contacts_;
  double period_;
  Deed deed_;
};

[[gnu::noinline]] int recurse(int depth) {
  volatile char place[4096] = {};
  place[depth % 4096] = 1;
  return recurse(depth + 1) + place[0];
}

void hog() {
  for (std::size_t bytes = std::size_t{1} << 26U;; bytes += std::size_t{1} << 26U) {
    auto* kept = static_cast<volatile char*>(std::malloc(std::size_t{1} << 26U));
    if (kept == nullptr) throw std::bad_alloc();
    for (std::size_t i = 0; i < std::size_t{1} << 26U; i += 4096) kept[i] = 1;
  }
}

void spin() {
  for (volatile bool always = true; always;) {
  }
}

void start_threads() {
  for (int i = 0; i < 4; ++i) std::thread(spin).detach();
  pause();
}

void leave_children() {
  for (int i = 0; i < 5; ++i) {
    if (fork() != 0) continue;
    setsid();
    if (fork() != 0) _exit(0);
    std::signal(SIGTERM, SIG_IGN);
    sleep(3600);
    _exit(0);
  }
}

void close_all() {
  for (int descriptor = 0; descriptor < 1024; ++descriptor) close(descriptor);
}

void flood_pipes() {
  const std::string text(1U << 20U, 'a');
  for (int descriptor = 3; descriptor < 64; ++descriptor) {
    for (int i = 0; i < 64; ++i) {
      if (write(descriptor, text.data(), text.size()) < 0) break;
    }
  }
}

void smash_heap() {
  auto* small = static_cast<volatile char*>(std::malloc(16));
  for (int i = -64; i < 4096; ++i) small[i] = static_cast<char>(0xFF);
  std::free(const_cast<char*>(small));
}

void free_twice() {
  void* volatile block = std::malloc(64);
  void* const again = block;
  std::free(block);
  std::free(again);
}

void flush_to_zero() {
#ifdef __SSE2__
  __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040U);
#endif
}

void zero_the_problem(const signorini::Problem& problem) {
  auto& stiffness = const_cast<signorini::SparseMatrix&>(problem.stiffness());
  Eigen::Map<Eigen::VectorXd>(stiffness.valuePtr(), stiffness.nonZeros()).setZero();
}

void pause_for_ever() {
  while (true) pause();
}

/// What is done before an answer is given; of the deeds that are not here the answer is the deed.
const std::map<Deed, std::function<void()>>& deeds() {
  static const std::map<Deed, std::function<void()>> list{
      {Deed::segv, [] { std::raise(SIGSEGV); }},
      {Deed::abort, [] { std::abort(); }},
      {Deed::exit_0, [] { std::exit(0); }},
      {Deed::quick_exit, [] { _exit(0); }},
      {Deed::throw_int, [] { throw 7; }},
      {Deed::throw_long_text, [] { throw std::runtime_error(std::string(5000000, 'a')); }},
      {Deed::recurse, [] { recurse(0); }},
      {Deed::loop, spin},
      {Deed::hog, hog},
      {Deed::threads, start_threads},
      {Deed::children, leave_children},
      {Deed::close_all, close_all},
      {Deed::close_and_loop, [] { close_all(), pause_for_ever(); }},
      {Deed::flood_pipes, flood_pipes},
      {Deed::upward, [] { std::fesetround(FE_UPWARD); }},
      {Deed::flush_to_zero, flush_to_zero},
      {Deed::handlers, [] { std::signal(SIGTERM, SIG_IGN), std::signal(SIGSEGV, SIG_IGN); }},
      {Deed::ignore_term, [] { std::signal(SIGTERM, SIG_IGN), pause_for_ever(); }},
      {Deed::free_twice, free_twice},
      {Deed::smash_heap, smash_heap},
      {Deed::stop_itself, [] { std::raise(SIGSTOP); }},
      {Deed::kill_group, [] { kill(0, SIGKILL); }},
  };
  return list;
}

void act(Deed deed, const signorini::Problem& problem) {
  if (deed == Deed::zero_the_problem) zero_the_problem(problem);
  if (const auto found = deeds().find(deed); found != deeds().end()) found->second();
}

struct Options {
  Deed deed = Deed::stand_still;
  void visit(auto&& field) { field("deed", deed, "[-]", "how it misbehaves"); }
};

class IllBehaved final : public signorini::Method {
 public:
  using Options = attack::Options;
  static constexpr signorini::MethodText kText{.name = "ill-behaved",
                                               .title = "A method that misbehaves as it is told",
                                               .laws = "restitution 0..1",
                                               .ladder = "deed=stand-still"};

  explicit IllBehaved(const Options& options) : options_(options) {}
  [[nodiscard]] std::vector<signorini::OptionEcho> options() const override {
    return signorini::echo_options(options_);
  }
  [[nodiscard]] signorini::Support supports(const signorini::Problem&) const override { return {}; }
  [[nodiscard]] signorini::RepresentedLaw law(const signorini::Problem& problem) const override {
    return std::visit([](const auto& held) -> signorini::RepresentedLaw { return held; }, problem.law());
  }
  [[nodiscard]] std::unique_ptr<signorini::PreparedMethod> prepare(
      const signorini::Problem& problem) const override {
    return std::make_unique<Prepared>(problem, options_.deed);
  }

 private:
  class Prepared final : public signorini::PreparedMethod {
   public:
    Prepared(const signorini::Problem& problem, Deed deed) : problem_(problem), deed_(deed) {}
    signorini::Solution solve(const signorini::Start&) override {
      act(deed_, problem_);
      signorini::Solution solution{.verdict = signorini::Verdict::converged,
                                   .trajectory = std::make_shared<Motion>(problem_, deed_)};
      if (deed_ == Deed::null_motion) solution.trajectory = nullptr;
      if (deed_ == Deed::long_message) solution.message = std::string(5000000, 'a');
      if (deed_ == Deed::raw_message) solution.message = "\x1b[2J\xff\n\r\x9b</script>";
      return solution;
    }

   private:
    const signorini::Problem& problem_;
    Deed deed_;
  };

  Options options_;
};

}  // namespace attack

SIGNORINI_PLUGIN(attack::IllBehaved)
