#include "voronaut/environments/formats/xml_scanner.h"

#include <algorithm>

namespace voronaut {
namespace {

constexpr std::string_view kBlank = " \t\r\n";

// Where the tag that the text begins with has its '>'; in the quotes of a value it may have others.
std::size_t end_of_tag(std::string_view text) {
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0)
      quote = c == quote ? char{0} : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == '>')
      return i;
  }
  return std::string_view::npos;
}

// The same of a <!DOCTYPE, whose own declarations stand in brackets.
std::size_t end_of_declaration(std::string_view text) {
  const std::size_t end = text.find('>');
  const std::size_t bracket = text.find('[');
  return bracket < end ? text.find('>', text.find(']', bracket)) : end;
}

}  // namespace

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
    inner_.clear();
    return true;
  }
  if (!skip_to_tag()) return false;
  const std::size_t end = end_of_tag(text_);
  if (end == std::string_view::npos) throw error("a tag does not end");
  const std::string_view tag = text_.substr(1, end - 1);
  if (tag.starts_with('/'))
    close(tag.substr(1));
  else
    open(tag);
  advance(end + 1);
  return true;
}

std::optional<std::string_view> XmlScanner::attribute(std::string_view name) const {
  std::string_view rest = attributes_;
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kBlank), rest.size()));
    const std::size_t equals = rest.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    const std::string_view key = rest.substr(0, rest.find_first_of("= \t\r\n"));
    rest.remove_prefix(equals + 1);
    rest.remove_prefix(std::min(rest.find_first_not_of(kBlank), rest.size()));
    const bool quoted = rest.starts_with('"') || rest.starts_with('\'');
    const std::size_t end = quoted ? rest.find(rest[0], 1) : std::string_view::npos;
    if (end == std::string_view::npos) throw error("an attribute's value is not in quotes");
    if (key == name) return rest.substr(1, end - 1);
    rest.remove_prefix(end + 1);
  }
}

// Over text, which it keeps, comments and declarations.
bool XmlScanner::skip_to_tag() {
  constexpr std::string_view kData = "<![CDATA[";
  inner_.clear();
  while (true) {
    const std::size_t begin = text_.find('<');
    inner_ += text_.substr(0, begin);
    if (begin == std::string_view::npos) {
      if (!open_.empty()) throw error("the file ends inside <" + open_.back() + ">");
      return false;
    }
    advance(begin);
    if (text_.starts_with("<!--")) {
      skip_past(text_.find("-->", 4), 3);
    } else if (text_.starts_with(kData)) {
      const std::size_t end = text_.find("]]>", kData.size());
      inner_ += text_.substr(kData.size(), end - kData.size());
      skip_past(end, 3);
    } else if (text_.starts_with("<?")) {
      skip_past(text_.find("?>"), 2);
    } else if (text_.starts_with("<!")) {
      skip_past(end_of_declaration(text_), 1);
    } else {
      return true;
    }
  }
}

void XmlScanner::skip_past(std::size_t begin_of_end, std::size_t length) {
  if (begin_of_end == std::string_view::npos) throw error("a comment or declaration does not end");
  advance(begin_of_end + length);
}

void XmlScanner::open(std::string_view tag) {
  ends_at_once_ = tag.ends_with('/');
  if (ends_at_once_) tag.remove_suffix(1);
  const std::string_view name = tag.substr(0, tag.find_first_of(kBlank));
  if (name.empty()) throw error("a tag has no name");
  if (name.find('/') != std::string_view::npos) throw error("a name with a '/'");  // it parts paths
  if (open_.size() == kDeepest) throw error("elements nested too deep");
  attributes_ = tag.substr(name.size());
  open_.emplace_back(name);
  if (!path_.empty()) path_ += '/';
  path_ += name;
  starts_ = true;
}

void XmlScanner::close(std::string_view name) {
  name = name.substr(0, name.find_first_of(kBlank));
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
