#include "harness/view/gallery.h"

#include <utility>

namespace fillrule::view {

Gallery::Gallery(Draws candidate_draws, bool has_reference, bool of_scene)
    : candidate_draws_(std::move(candidate_draws)), has_reference_(has_reference), of_scene_(of_scene) {}

Result<std::unique_ptr<Gallery>> Gallery::create(const run::RunOptions& options, bool is_judged, bool of_scene) {
  Result<Draws> draws = candidate_draws(options);
  if (!draws) return tl::unexpected(draws.error());
  const bool has_reference = is_judged && options.reference != run::kNoReference;
  std::unique_ptr<Gallery> gallery(new Gallery(std::move(*draws), has_reference, of_scene));
  if (!is_judged) return gallery;
  Result<run::SuiteRunner> runner = run::SuiteRunner::create(options);
  if (!runner) return tl::unexpected(runner.error());
  gallery->start_judge(std::move(*runner));
  if (!has_reference || !of_scene) return gallery;
  gallery->reference_worker_ =
      std::make_unique<LatestWorker<Job, Picture>>([draws = reference_draws(options)](const Job& job) {
        Picture picture{.version = job->version};
        if (const Result<void> done = draws(*job, picture.image); !done) picture.error = to_string(done.error());
        return picture;
      });
  return gallery;
}

void Gallery::start_judge(run::SuiteRunner runner) {
  const auto shared = std::make_shared<run::SuiteRunner>(std::move(runner));
  judge_ = std::make_unique<LatestWorker<Job, VerdictPicture>>([shared](const Job& job) {
    VerdictPicture picture{.judged = {.version = job->version}};
    Result<Judged> judged = judge_view(*shared, *job);
    if (judged) {
      picture.judged = std::move(*judged);
    } else {
      picture.error = to_string(judged.error());
    }
    return picture;
  });
}

void Gallery::draw(View& view) {
  if (version_ == view.changes()) return;
  version_ = view.changes();
  Result<Drawable> drawable = view.drawable();
  if (!drawable) {
    candidate_.error = to_string(drawable.error());
    return;
  }
  const Job job = std::make_shared<const Drawable>(std::move(*drawable));
  candidate_.version = job->version;
  const Result<void> done = candidate_draws_(*job, candidate_.image);
  candidate_.error = done ? "" : to_string(done.error());
  candidate_.stamp = ++stamp_;
  if (reference_worker_) reference_worker_->submit(job);
  if (judge_) judge_->submit(job);
}

bool Gallery::take() {
  if (reference_worker_) {
    if (auto drawn = reference_worker_->take()) {
      reference_ = std::move(drawn);
      reference_->stamp = ++stamp_;
    }
  }
  auto verdict = judge_ ? judge_->take() : std::nullopt;
  if (!verdict) return false;
  verdict_ = std::move(verdict);
  verdict_->stamp = ++stamp_;
  if (of_scene_ || !verdict_->error.empty()) return true;
  // In colours of both parties' range.
  const Judged& judged = verdict_->judged;
  if (judged.version == candidate_.version) {
    candidate_.image = judged.candidate;
    candidate_.stamp = ++stamp_;
  }
  if (judged.reference)
    reference_ = Picture{.version = judged.version, .stamp = ++stamp_, .image = *judged.reference};
  return true;
}

void Gallery::wait() {
  if (reference_worker_) reference_worker_->wait();
  if (judge_) judge_->wait();
}

const Judged* Gallery::current_verdict() const {
  const bool is_current = verdict_ && verdict_->error.empty() && verdict_->judged.version == version_;
  return is_current ? &verdict_->judged : nullptr;
}

std::string Gallery::error() const {
  if (!candidate_.error.empty()) return candidate_.error;
  if (verdict_ && !verdict_->error.empty()) return verdict_->error;
  return reference_ ? reference_->error : std::string();
}

}  // namespace fillrule::view
