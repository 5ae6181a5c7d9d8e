// The catalogue of classic faults: mistakes that rasterizers are known to make, each of which the naive rasterizer of
// this folder can be told to make. Where the code makes one, it says `if (context.has(Fault::kName))`.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/model/result.h"

namespace fillrule::faults {

enum class Fault : uint8_t {
  kNone,

  // Primitive assembly
  kStripParityIgnored,
  kStripParityRunsOverRestart,
  kFanProvokesHub,
  kFanTurnedOver,
  kFlatFromLastVertex,
  kFlatInterpolated,
  kRestartIgnored,
  kRestartOf32BitsOnly,
  kOffsetBeforeRestart,
  kOffsetIgnored,
  kNanVertexKillsDraw,
  kOrderLostBetweenThreads,

  // Clipping
  kNoNearClip,
  kNoFarClip,
  kDepthClipAlways,
  kGlDepthVolume,
  kMinusOneToOneIgnored,
  kClipAfterDivide,
  kDropIfAnyOutside,
  kDropIfAllOutside,
  kDropIfAnyBehindEye,
  kUnclippedIfAnyInside,
  kNegativeSideKept,
  kWSignIgnored,
  kStretchToOrigin,
  kSmallWCutOff,
  kWindingAfterClip,
  kFirstPieceOnly,
  kClipKeepsAttributes,
  kClipNoperspectiveInSpace,
  kClipCornersToPixels,
  kUserClipIgnored,
  kUserClipAffine,
  kCullDistanceOfAnyVertex,
  kCullDistanceAcrossPlanes,
  kSpillsOverViewport,

  // Viewport, snapping, facing
  kFixedPointOverflow,
  kGuardBandClamps,
  kCullRangeTooSmall,
  kViewportOriginTruncated,
  kNegativeHeightIgnored,
  kReciprocalTooCoarse,
  kSnapByTruncation,
  kSnapToPixels,
  kSnapRowsToPixels,
  kFacingBeforeDivide,
  kFacingUnflipped,
  kFrontFaceIgnored,
  kZeroAreaIsFront,
  kSmallAreaRejected,
  kLinesCulled,
  kPolygonModeBeforeCulling,

  // Coverage
  kPixelCorners,
  kEdgesInclusive,
  kEdgesExclusive,
  kBottomRightRule,
  kHorizontalTies,
  kFloatEdges,
  kEdgesIn32Bits,
  kSpansTruncated,
  kRowsFromTheirTop,
  kLastColumnMissing,
  kColumnBeyondTarget,
  kMissesBetweenCentres,
  kSamplesMirrored,
  kSamplesOnRegularGrid,
  kSampleMaskIgnored,
  kScissorOffByOne,
  kScissorMirrored,

  // Lines, points, outlines
  kLineEndTwice,
  kLineStartMissing,
  kLineTies,
  kLineAsParallelogram,
  kLineWidthIgnored,
  kOutlineOfPieces,
  kPointSizeRounded,
  kPointsDroppedAtBorder,
  kPointsBeyondVolume,
  kPointCoordFlipped,

  // Depth
  kPerspectiveDepth,
  kDepthOfPrimitive,
  kClipDepthUndivided,
  kDepthRangeSorted,
  kDepthNotClamped,
  kDepthCompareOffByEqual,
  kDepthWriteAlways,
  kDepthInHalfPrecision,
  kDepthComparedUnrounded,
  kDepthBoundsOfFragment,
  kBiasSign,
  kBiasSlopeMissing,
  kBiasDoubled,
  kBiasUnitFixed,
  kBiasClampIgnored,

  // Interpolation
  kAffineVaryings,
  kNoperspectiveAsSmooth,
  kIntegerWeights,
  kCoarseWeights,
  kWeightsSwapped,
  kValuesAtPixelCorner,
  kValuesOneStepLate,
  kCentroidAtCentre,
  kSampleAtCentre,
  kFragCoordW,
  kFragCoordAtCorner,
  kNanVaryingDiscards,
};

struct FaultEntry {
  Fault fault = Fault::kNone;
  std::string_view name;  // the enumerator in snake_case
  std::string_view what;  // what the rasterizer does then, in one line
  std::string_view
      source;  // a public report of a bug of this class, or "hand-written": what such renderers get wrong
};

// All faults in the order of the enumeration, without kNone.
std::span<const FaultEntry> catalogue();

// "none" is kNone. The error tells the nearest name, or all of them.
Result<Fault> fault_named(std::string_view name);

std::vector<std::string> fault_names();

}  // namespace fillrule::faults
