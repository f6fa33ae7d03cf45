#include "fuzz/campaign/campaign.hpp"
#include "fuzz/campaign/runner.hpp"

namespace circumspect::campaign {

Input minimised(const Input& input, const std::string& signature, Runner& runner,
                const MinimiseLimits& limits, const std::atomic<bool>& stop) {
  MinimiseLimits until_stopped = limits;
  until_stopped.stop = &stop;
  const auto made_small = [&](bool anew) -> Input {
    const auto fails = [&](const Input& candidate) {
      return !stop &&
             (anew ? runner.run_anew(candidate) : runner.run(candidate)).signature == signature;
    };
    return std::visit(
        [&]<class Case>(const Case& one) -> Input {
          return minimised(one, generators::StillFails<Case>(fails), until_stopped);
        },
        input);
  };
  // A worker that has had earlier cases is fast, but these may cause wrong answers.
  Input small = made_small(false);
  if (stop || runner.run_anew(small).signature == signature) return small;
  return made_small(true);
}

}  // namespace circumspect::campaign
