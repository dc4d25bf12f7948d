#include "voronaut/environments/formats/xml_scanner.h"

#include <algorithm>

namespace voronaut {

bool XmlScanner::next() {
  if (leaves_) {
    path_.resize(path_.size() - open_.back().size());
    if (!path_.empty()) path_.pop_back();
    open_.pop_back();
    leaves_ = false;
  }
  if (ends_at_once_) {
    ends_at_once_ = false;
    starts_ = false;
    leaves_ = true;
    inner_ = {};
    return true;
  }
  if (!skip_to_tag()) return false;
  const std::size_t end = text_.find('>');
  if (end == std::string_view::npos) throw error("a tag does not end");
  const std::string_view tag = text_.substr(1, end - 1);
  if (tag.starts_with('/'))
    close(tag.substr(1));
  else
    open(tag);
  advance(end + 1);
  return true;
}

// Over text, comments and declarations.
bool XmlScanner::skip_to_tag() {
  while (true) {
    const std::size_t begin = text_.find('<');
    inner_ = text_.substr(0, begin);
    if (begin == std::string_view::npos) {
      if (!open_.empty()) throw error("the file ends inside <" + open_.back() + ">");
      return false;
    }
    advance(begin);
    const bool comment = text_.starts_with("<!--");
    if (!comment && !text_.starts_with("<?") && !text_.starts_with("<!")) return true;
    const std::size_t end = text_.find(comment ? "-->" : ">");
    if (end == std::string_view::npos) throw error("a comment or declaration does not end");
    advance(end + (comment ? 3 : 1));
  }
}

void XmlScanner::open(std::string_view tag) {
  ends_at_once_ = tag.ends_with('/');
  if (ends_at_once_) tag.remove_suffix(1);
  const std::string_view name = tag.substr(0, tag.find_first_of(" \t\r\n"));
  if (name.empty()) throw error("a tag has no name");
  if (open_.size() == kDeepest) throw error("elements nested too deep");
  open_.emplace_back(name);
  if (!path_.empty()) path_ += '/';
  path_ += name;
  starts_ = true;
}

void XmlScanner::close(std::string_view name) {
  name = name.substr(0, name.find_first_of(" \t\r\n"));
  if (open_.empty() || open_.back() != name)
    throw error("</" + std::string(name.substr(0, 60)) + "> ends what is not open");
  starts_ = false;
  leaves_ = true;
}

void XmlScanner::advance(std::size_t count) {
  line_ += static_cast<int>(
      std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(count), '\n'));
  text_.remove_prefix(count);
}

}  // namespace voronaut
