// What the oracle can judge.
#pragma once

#include "cases/model/features.h"

namespace fillrule::exact {

inline FeatureSet oracle_features() {
  FeatureSet set;
  for (const Feature feature : {Feature::kPoints, Feature::kLargePoints, Feature::kLines, Feature::kBresenhamLines,
                                Feature::kWideLines, Feature::kFillModeNonSolid}) {
    set.add(feature);
  }
  return set;
}

}  // namespace fillrule::exact
