#pragma once

#include <nlohmann/json.hpp>

#include "voronaut/environments/config/key_visitor.h"

namespace voronaut {

// The values of a visit list as a JSON object in the order of the list; sections are objects, forms
// are left out.
nlohmann::ordered_json keys_json(const VisitKeys& keys);

template <class Config>
nlohmann::ordered_json config_json(Config config) {
  return keys_json(keys_of(config));
}

}  // namespace voronaut
