#include "reports/report.h"

namespace plumb {

const char* name_of(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::failed:
      return "failed";
    case Status::not_supported:
      return "not supported";
  }
  return "";
}

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::right:
      return "right";
    case Verdict::plausible:
      return "plausible";
    case Verdict::wrong:
      return "wrong";
    case Verdict::beyond_horizon:
      return "beyond horizon";
    case Verdict::not_supported:
      return "not supported";
    case Verdict::failed:
      return "failed";
  }
  return "";
}

std::string label_of(const std::string& engine, const std::string& method) {
  return method.empty() ? engine : engine + ":" + method;
}

}  // namespace plumb
