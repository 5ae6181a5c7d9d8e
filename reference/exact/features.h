// What the oracle can judge.
#pragma once

#include "cases/model/features.h"

namespace fillrule::exact {

inline FeatureSet oracle_features() {
  return FeatureSet::all();
}

}  // namespace fillrule::exact
