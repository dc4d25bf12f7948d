#include "voronaut/environments/formats/xml_document.h"

#include <algorithm>

#include <tinyxml2.h>

namespace voronaut {
namespace {

const char* problem_of(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "an element does not end, or another one ends in its place";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute without a value in quotes";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
    case tinyxml2::XML_ERROR_PARSING_CDATA:
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
    case tinyxml2::XML_ERROR_PARSING_UNKNOWN:
      return "a comment or declaration does not end";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements nested too deep";
    default:
      return "a tag or an element does not end";
  }
}

}  // namespace

std::string XmlElement::name() const { return element_->Name(); }

std::string XmlElement::text() const {
  std::string text;
  for (const auto* node = element_->FirstChild(); node != nullptr; node = node->NextSibling())
    if (node->ToText() != nullptr) text += node->Value();
  constexpr const char* kBlank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string XmlElement::attribute(const char* name) const {
  const char* value = element_->Attribute(name);
  return value == nullptr ? "" : value;
}

std::vector<XmlElement> XmlElement::children() const { return children(nullptr); }

std::vector<XmlElement> XmlElement::children(const char* name) const {
  std::vector<XmlElement> found;
  for (const auto* child = element_->FirstChildElement(name); child != nullptr;
       child = child->NextSiblingElement(name))
    found.push_back({*child, *file_});
  return found;
}

std::optional<XmlElement> XmlElement::child(const char* name) const {
  const auto* found = element_->FirstChildElement(name);
  if (found == nullptr) return std::nullopt;
  return XmlElement(*found, *file_);
}

ConfigError XmlElement::error(std::string_view problem) const {
  return {*file_, element_->GetLineNum(), "", problem};
}

XmlDocument::XmlDocument(std::string_view text, std::string file)
    : file_(std::move(file)), document_(std::make_unique<tinyxml2::XMLDocument>()) {
  const tinyxml2::XMLError error = document_->Parse(text.data(), text.size());
  if (error == tinyxml2::XML_SUCCESS || error == tinyxml2::XML_ERROR_EMPTY_DOCUMENT) return;
  throw ConfigError(file_, std::max(document_->ErrorLineNum(), 1), "",
                    std::string("not valid XML: ") + problem_of(error));
}

XmlDocument::~XmlDocument() = default;

std::optional<XmlElement> XmlDocument::root() const {
  const auto* root = document_->RootElement();
  if (root == nullptr) return std::nullopt;
  return XmlElement(*root, file_);
}

}  // namespace voronaut
