#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "voronaut/environments/config/config_error.h"

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace voronaut {

// An element of an XmlDocument, which must outlive it. Cheap to copy.
class XmlElement {
 public:
  std::string name() const;
  // What stands between its tags, without comments and without what its own elements hold; blanks
  // at both ends are left out.
  std::string text() const;
  // The value of an attribute, empty where it is missing.
  std::string attribute(const char* name) const;

  std::vector<XmlElement> children() const;                  // in the order of the file
  std::vector<XmlElement> children(const char* name) const;  // that are called so
  std::optional<XmlElement> child(const char* name) const;   // the first of them

  // A fault in the line in which it begins.
  ConfigError error(std::string_view problem) const;

 private:
  friend class XmlDocument;
  XmlElement(const tinyxml2::XMLElement& element, const std::string& file)
      : element_(&element), file_(&file) {}

  const tinyxml2::XMLElement* element_;
  const std::string* file_;
};

// An XML text as a tree whose elements know their line.
class XmlDocument {
 public:
  // Throws ConfigError with the line for what is not XML. `file` is what messages call it.
  XmlDocument(std::string_view text, std::string file);
  ~XmlDocument();
  XmlDocument(const XmlDocument&) = delete;
  XmlDocument& operator=(const XmlDocument&) = delete;

  // None of an empty text.
  std::optional<XmlElement> root() const;

 private:
  std::string file_;
  std::unique_ptr<tinyxml2::XMLDocument> document_;
};

}  // namespace voronaut
