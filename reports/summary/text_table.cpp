#include "voronaut/reports/summary/text_table.h"

#include <algorithm>

namespace voronaut {

namespace {

std::string escaped_for_markdown(const std::string& cell) {
  std::string out;
  for (const char c : cell) {
    if (c == '|' || c == '\\' || c == '<' || c == '*' || c == '_' || c == '`') {
      out += '\\';
    }
    out += c;
  }
  return out;
}

// The part of a heading above or below its line break.
std::string heading_line(const std::string& heading, bool lower) {
  const std::size_t end = heading.find('\n');
  if (end == std::string::npos) return lower ? "" : heading;
  return lower ? heading.substr(end + 1) : heading.substr(0, end);
}

}  // namespace

std::size_t text_width(std::string_view utf8) {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

std::string printable(std::string_view text) {
  std::string out(text);
  std::replace_if(
      out.begin(), out.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == 0x7F; }, '?');
  return out;
}

std::string TextTable::aligned() const {
  std::vector<std::size_t> widths;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const std::string& heading = columns[k].heading;
    std::size_t width =
        std::max(text_width(heading_line(heading, false)), text_width(heading_line(heading, true)));
    for (const auto& row : rows) {
      width = std::max(width, text_width(row[k]));
    }
    widths.push_back(width);
  }
  std::string out;
  const auto put_line = [&](auto&& cell) {
    std::string line;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const std::string text = cell(k);
      const std::string blanks(widths[k] - text_width(text), ' ');
      line += k == 0 ? "" : "  ";
      line += columns[k].align == Align::left ? text + blanks : blanks + text;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
  };
  put_line([&](std::size_t k) { return heading_line(columns[k].heading, false); });
  if (std::any_of(columns.begin(), columns.end(),
                  [](const Column& c) { return c.heading.find('\n') != std::string::npos; })) {
    put_line([&](std::size_t k) { return heading_line(columns[k].heading, true); });
  }
  for (const auto& row : rows) {
    put_line([&](std::size_t k) { return row[k]; });
  }
  return out;
}

std::string TextTable::markdown() const {
  std::string out = "|";
  std::string rule = "|";
  for (const Column& column : columns) {
    std::string heading = column.heading;
    std::replace(heading.begin(), heading.end(), '\n', ' ');
    out += " " + escaped_for_markdown(heading) + " |";
    rule += column.align == Align::left ? ":---|" : "---:|";
  }
  out += "\n" + rule + "\n";
  for (const auto& row : rows) {
    out += "|";
    for (const std::string& cell : row) {
      out += " " + escaped_for_markdown(cell) + " |";
    }
    out += "\n";
  }
  return out;
}

}  // namespace voronaut
