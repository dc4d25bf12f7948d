#include "voronaut/reports/summary/natural_order.h"

#include <algorithm>

namespace voronaut {

bool natural_less(std::string_view a, std::string_view b) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto digits = [&](std::string_view text) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
    return text.substr(0, static_cast<std::size_t>(end - text.begin()));
  };
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view run_a = digits(a);
      const std::string_view run_b = digits(b);
      const std::string_view value_a =
          run_a.substr(std::min(run_a.find_first_not_of('0'), run_a.size()));
      const std::string_view value_b =
          run_b.substr(std::min(run_b.find_first_not_of('0'), run_b.size()));
      if (value_a != value_b) {
        return value_a.size() != value_b.size() ? value_a.size() < value_b.size()
                                                : value_a < value_b;
      }
      a.remove_prefix(run_a.size());
      b.remove_prefix(run_b.size());
    } else if (a.front() != b.front()) {
      return a.front() < b.front();
    } else {
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.size() < b.size();
}

}  // namespace voronaut
