// The newest pictures of a view, and the verdict on it: who draws them in which thread is here.
//
// The candidate draws at once, in the caller's thread. The reference draws, and the judge judges, in threads of their
// own, always the newest view; what they have finished last may be of an earlier one. Every picture is drawn apart
// and handed over when it is whole.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "cases/model/result.h"
#include "harness/run/suite_runner.h"
#include "harness/view/image.h"
#include "harness/view/latest_worker.h"
#include "harness/view/parties.h"
#include "harness/view/view.h"

namespace fillrule::view {

struct Picture {
  uint64_t version = 0;  // of the view
  uint64_t stamp = 0;    // another one for each image
  Image image;
  std::string error;  // why there is no image
};

struct VerdictPicture {
  uint64_t stamp = 0;
  Judged judged;
  std::string error;
};

class Gallery {
 public:
  // Errors: a party that is not there. Without `is_judged` the candidate is alone.
  static Result<std::unique_ptr<Gallery>> create(const run::RunOptions& options, bool is_judged, bool of_scene);

  // Draws the view, if it has changed, and has it drawn and judged by the others.
  void draw(View& view);
  // Takes what they have finished. Whether there is a new verdict.
  bool take();
  // Until they have finished.
  void wait();

  [[nodiscard]] bool has_judge() const { return judge_ != nullptr; }
  [[nodiscard]] bool has_reference() const { return has_reference_; }
  [[nodiscard]] const Picture& candidate() const { return candidate_; }
  [[nodiscard]] const std::optional<Picture>& reference() const { return reference_; }
  [[nodiscard]] const std::optional<VerdictPicture>& verdict() const { return verdict_; }
  // Of the view as it was drawn last.
  [[nodiscard]] const Judged* current_verdict() const;
  [[nodiscard]] std::optional<uint64_t> version() const { return version_; }
  [[nodiscard]] std::string error() const;  // empty if all is well

 private:
  using Job = std::shared_ptr<const Drawable>;

  Gallery(Draws candidate_draws, bool has_reference, bool of_scene);
  void start_judge(run::SuiteRunner runner);

  Draws candidate_draws_;
  bool has_reference_;
  bool of_scene_;
  std::optional<uint64_t> version_;
  uint64_t stamp_ = 0;  // the last one that was given to an image
  Picture candidate_;
  std::optional<Picture> reference_;
  std::optional<VerdictPicture> verdict_;
  // Last, so that they end before anything else does.
  std::unique_ptr<LatestWorker<Job, Picture>> reference_worker_;
  std::unique_ptr<LatestWorker<Job, VerdictPicture>> judge_;
};

}  // namespace fillrule::view
