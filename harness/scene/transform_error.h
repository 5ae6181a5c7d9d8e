// How far a vertex that is transformed in float32 may be from the one transformed in double.
//
// Derivation. A product of a 4x4 matrix and a vector rounds each component's four products and three sums, and the
// matrix' entries were rounded before: with u = 2^-24 it errs by at most 5 u |M| |v|, componentwise, first order.
// Three of them in a row, world = M v, eye = V world, clip = P eye, err by at most 15 u |P| |V| |M| |v|; the host
// rounds its double once more, hence 16. A window coordinate W/2 (x / w) then moves by W/2 (e_x + |x / w| e_w) / (w -
// e_w).
//
// A pixel's share of that goes into the judgement as one subpixel bit less: with b bits a party may snap by 2^-(b+1)
// pixels, and the oracle allows 2^-b, so that 2^-(b+1) are left for the transformation.
#pragma once

#include "cases/model/case.h"
#include "cases/model/result.h"
#include "harness/programs/shading.h"
#include "harness/scene/color_judge.h"

namespace fillrule::scene {

// `object` is built by object_case(), `shading` with transforms. Fails where a vertex's window position may move by
// more than 2^-(subpixel_bits + 1) pixels.
Result<TransformError> transform_error(const Case& object, const programs::CaseShading& shading,
                                       uint32_t subpixel_bits);

}  // namespace fillrule::scene
