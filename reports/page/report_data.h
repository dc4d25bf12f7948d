#pragma once

#include <string>
#include <string_view>

#include "voronaut/reports/page/html_report.h"

namespace voronaut {

// What the page reads from its <script type="application/json">:
//   {"title", "manifest", "outcomes":[...], "summary":{...}, "trials":{column: numbers | texts},
//    "worlds":[...], "traces":{trial_id: base64}, "stored_traces", "stored_trials",
//    "folder", "comparison": {...} or null, "published": {...} or null}
// A column of texts is {"texts":[distinct], "index":[...]}, one of numbers is a plain array,
// rounded to seven digits, null where absent. state_digest is left out: 64 characters a row nobody
// reads.
std::string report_data_json(const ReportInput& input);

// JSON inside a <script> element: every '<' becomes \u003c, so that no text can end the element;
// U+2028 and U+2029 are escaped too.
std::string escaped_for_script(std::string_view json);

std::string escaped_for_html(std::string_view text);

}  // namespace voronaut
