#include "reports/timing/course.h"

#include <limits>

namespace plumb {
namespace {

bool left_something(const RunRecord& run) { return run.scene && run.trace && run.trace->size() > 0; }

// What a run's poses are measured by: the closed form of its case, else the first engine, as the comparator has it.
const RunRecord* reference_of(const Report& report, const RunRecord& run) {
  const RunRecord* reference = nullptr;
  for (const RunRecord& other : report.runs) {
    if (other.scenario != run.scenario || other.variant != run.variant || other.status != Status::ok) continue;
    if (other.exact) return &other;
    if (reference == nullptr) reference = &other;
  }
  return reference;
}

Course course_of(const RunRecord& run, const RunRecord* reference) {
  Course course{.run = &run};
  if (reference != nullptr && left_something(*reference)) {
    course.apart = pose_differences(*run.scene, *run.trace, *reference->trace, std::numeric_limits<double>::infinity());
  }
  const Overlap overlap(*run.scene);
  for (std::size_t i = 0; i < run.trace->size(); ++i) course.deepest.push_back(overlap.deepest(run.trace->states(i)));
  return course;
}

}  // namespace

std::vector<Course> courses_of(const Report& report) {
  std::vector<Course> courses;
  for (const RunRecord& run : report.runs) {
    if (left_something(run)) courses.push_back(course_of(run, reference_of(report, run)));
  }
  return courses;
}

}  // namespace plumb
