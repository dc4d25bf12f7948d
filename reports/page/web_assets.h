#pragma once

#include <string_view>

namespace voronaut {

// The report's page as bundled at build time from reports/web. Hashes as a content security policy
// names them: "sha256-<base64>".
struct WebAssets {
  std::string_view template_html;
  std::string_view style_css;
  std::string_view style_hash;
  std::string_view script_js;
  std::string_view script_hash;
};

WebAssets web_assets();

}  // namespace voronaut
