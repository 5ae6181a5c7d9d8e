#include "harness/faults/fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cases/format/suggestion.h"

namespace fillrule::faults {
namespace {

constexpr std::string_view kHandWritten = "hand-written";

constexpr auto kCatalogue = std::to_array<FaultEntry>({
    {Fault::kStripParityIgnored, "strip_parity_ignored", "every second triangle of a strip is wound the other way",
     kHandWritten},
    {Fault::kStripParityRunsOverRestart, "strip_parity_runs_over_restart",
     "the winding of a strip's triangles alternates on over a restart", "hedge-dev/UnleashedRecomp PR 428"},
    {Fault::kFanProvokesHub, "fan_provokes_hub", "flat varyings of a fan are those of its hub", kHandWritten},
    {Fault::kFanTurnedOver, "fan_turned_over", "triangles of a fan are wound the other way", kHandWritten},
    {Fault::kFlatFromLastVertex, "flat_from_last_vertex", "flat varyings are the last vertex's, whatever provokes",
     kHandWritten},
    {Fault::kFlatInterpolated, "flat_interpolated", "flat varyings are interpolated", kHandWritten},
    {Fault::kRestartIgnored, "restart_ignored", "the restart index is skipped, and the strip goes on", kHandWritten},
    {Fault::kRestartOf32BitsOnly, "restart_of_32_bits_only", "8 and 16-bit indices never restart", kHandWritten},
    {Fault::kOffsetBeforeRestart, "offset_before_restart", "the vertex offset is added before the restart compare",
     kHandWritten},
    {Fault::kOffsetIgnored, "offset_ignored", "the vertex offset is not added", kHandWritten},
    {Fault::kNanVertexKillsDraw, "nan_vertex_kills_draw", "primitives after one with a NaN are lost", kHandWritten},
    {Fault::kOrderLostBetweenThreads, "order_lost_between_threads",
     "of two threads that share the primitives of a draw, one is done before the other begins", "ZDoom/gzdoom#2783"},

    {Fault::kNoNearClip, "no_near_clip", "the near plane does not cut", "bulletphysics/bullet3#1006"},
    {Fault::kNoFarClip, "no_far_clip", "the far plane does not cut", kHandWritten},
    {Fault::kDepthClipAlways, "depth_clip_always", "near and far planes cut although depth clip is off",
     "Vita3K/Vita3K#4110"},
    {Fault::kGlDepthVolume, "gl_depth_volume", "the view volume begins at z = -w where 0 is meant", kHandWritten},
    {Fault::kMinusOneToOneIgnored, "minus_one_to_one_ignored", "z from -1 to 1 is taken as from 0 to 1",
     kHandWritten},
    {Fault::kClipAfterDivide, "clip_after_divide", "what needs clipping is divided by w first",
     "jdahlstrom/retrofire#3"},
    {Fault::kDropIfAnyOutside, "drop_if_any_outside", "a polygon is dropped if one vertex is outside",
     "zesterer/euc#33"},
    {Fault::kDropIfAllOutside, "drop_if_all_outside",
     "a polygon is dropped if all vertices are outside, although it crosses the volume",
     "KhronosGroup/Vulkan-Docs#1480"},
    {Fault::kDropIfAnyBehindEye, "drop_if_any_behind_eye", "a polygon is dropped if one w is not positive",
     "vindar/tgx#47"},
    {Fault::kUnclippedIfAnyInside, "unclipped_if_any_inside", "a polygon is kept unclipped if one vertex is inside",
     kHandWritten},
    {Fault::kNegativeSideKept, "negative_side_kept",
     "a clip flag of -1 is tested like a boolean: beyond the left and top planes is taken as inside", kHandWritten},
    {Fault::kWSignIgnored, "w_sign_ignored", "vertices behind the eye are mirrored to its front",
     "datoviz/datoviz#150"},
    {Fault::kStretchToOrigin, "stretch_to_origin", "vertices behind the eye are moved to the middle of the picture",
     "afritz1/OpenTESArena#252"},
    {Fault::kSmallWCutOff, "small_w_cut_off", "everything with w below 1e-4 is cut off", kHandWritten},
    {Fault::kWindingAfterClip, "winding_after_clip", "clipping that adds a corner turns the polygon over",
     kHandWritten},
    {Fault::kFirstPieceOnly, "first_piece_only", "of a clipped polygon only the first triangle is drawn",
     kHandWritten},
    {Fault::kClipKeepsAttributes, "clip_keeps_attributes", "a new corner has the inside vertex's varyings",
     "Victormeriqui/Consol3#20"},
    {Fault::kClipNoperspectiveInSpace, "clip_noperspective_in_space",
     "noperspective varyings of a new corner are interpolated in clip space", kHandWritten},
    {Fault::kClipCornersToPixels, "clip_corners_to_pixels", "new corners are rounded to whole pixels, outwards",
     "Marzac/le3d#38"},
    {Fault::kUserClipIgnored, "user_clip_ignored", "clip distances do not cut", kHandWritten},
    {Fault::kUserClipAffine, "user_clip_affine", "clip distances are interpolated in the window, not in space",
     kHandWritten},
    {Fault::kCullDistanceOfAnyVertex, "cull_distance_of_any_vertex", "one negative cull distance drops a primitive",
     kHandWritten},
    {Fault::kCullDistanceAcrossPlanes, "cull_distance_across_planes",
     "a primitive is dropped if each vertex is negative for some plane, not all for one", kHandWritten},
    {Fault::kSpillsOverViewport, "spills_over_viewport", "polygons are not cut at the viewport",
     "KhronosGroup/VK-GL-CTS#78"},

    {Fault::kFixedPointOverflow, "fixed_point_overflow", "positions wrap around in 16.16 fixed point",
     "dkfans/keeperfx PR 4668"},
    {Fault::kGuardBandClamps, "guard_band_clamps", "positions beyond 1024 px are moved to there, not clipped",
     "hrydgard/ppsspp#13269"},
    {Fault::kCullRangeTooSmall, "cull_range_too_small", "polygons with a vertex beyond 2048 px are dropped",
     "hrydgard/ppsspp#9622"},
    {Fault::kViewportOriginTruncated, "viewport_origin_truncated", "the viewport begins at a whole pixel",
     kHandWritten},
    {Fault::kNegativeHeightIgnored, "negative_height_ignored", "a viewport of negative height is not turned over",
     kHandWritten},
    {Fault::kReciprocalTooCoarse, "reciprocal_too_coarse", "1/w has 12 bits", "hrydgard/ppsspp#4853"},
    {Fault::kSnapByTruncation, "snap_by_truncation", "positions are truncated to subpixels", kHandWritten},
    {Fault::kSnapToPixels, "snap_to_pixels", "positions are rounded to whole pixels", kHandWritten},
    {Fault::kSnapRowsToPixels, "snap_rows_to_pixels", "y is rounded to whole pixels, x is not",
     "gonetz/GLideN64#1731"},
    {Fault::kFacingBeforeDivide, "facing_before_divide", "facing is found from clip-space x and y, undivided",
     "jdahlstrom/retrofire#3"},
    {Fault::kFacingUnflipped, "facing_unflipped", "facing is found before a viewport turns y over",
     "dolphin-emu/dolphin PR 9350"},
    {Fault::kFrontFaceIgnored, "front_face_ignored", "counter-clockwise is the front, whatever the state says",
     "SerenityOS/serenity PR 13738"},
    {Fault::kZeroAreaIsFront, "zero_area_is_front", "a polygon without area faces the front", kHandWritten},
    {Fault::kSmallAreaRejected, "small_area_rejected", "polygons of less than a quarter of a pixel are dropped",
     kHandWritten},
    {Fault::kLinesCulled, "lines_culled", "lines are culled like polygons that face away", kHandWritten},
    {Fault::kPolygonModeBeforeCulling, "polygon_mode_before_culling",
     "polygons drawn as lines or points are not culled", kHandWritten},

    {Fault::kPixelCorners, "pixel_corners", "samples are half a pixel up and left", kHandWritten},
    {Fault::kEdgesInclusive, "edges_inclusive", "samples on an edge belong to both sides", "JaCzekanski/Avocado#18"},
    {Fault::kEdgesExclusive, "edges_exclusive", "samples on an edge belong to neither side", "nesbox/TIC-80#776"},
    {Fault::kBottomRightRule, "bottom_right_rule", "ties go by a bottom-right rule", "MicrosoftDocs/win32 PR 2157"},
    {Fault::kHorizontalTies, "horizontal_ties", "ties at horizontal edges go to the row below",
     "SerenityOS/serenity PR 13738"},
    {Fault::kFloatEdges, "float_edges", "edge functions are computed in float32", kHandWritten},
    {Fault::kEdgesIn32Bits, "edges_in_32_bits", "products of edge functions wrap around at 32 bits",
     "Mesa commit 1165ff1, SwiftShader bd85ab2"},
    {Fault::kSpansTruncated, "spans_truncated", "spans go from one truncated end to the other, both included",
     kHandWritten},
    {Fault::kRowsFromTheirTop, "rows_from_their_top", "edges are taken at the top of a row of pixels", kHandWritten},
    {Fault::kLastColumnMissing, "last_column_missing", "the last column of a polygon's pixels is left out",
     kHandWritten},
    {Fault::kColumnBeyondTarget, "column_beyond_target", "x == width is accepted, and wraps to the next row",
     "raysan5/raylib#5838"},
    {Fault::kMissesBetweenCentres, "misses_between_centres",
     "with several samples a pixel is entered only if its centre is covered", kHandWritten},
    {Fault::kSamplesMirrored, "samples_mirrored", "sample locations are mirrored in x", kHandWritten},
    {Fault::kSamplesOnRegularGrid, "samples_on_regular_grid", "samples form a regular grid, as other APIs have them",
     kHandWritten},
    {Fault::kSampleMaskIgnored, "sample_mask_ignored", "the sample mask takes nothing away", kHandWritten},
    {Fault::kScissorOffByOne, "scissor_off_by_one", "the scissor lets one more column and row through", kHandWritten},
    {Fault::kScissorMirrored, "scissor_mirrored", "the scissor's y counts from below", "raysan5/raylib#5974"},

    {Fault::kLineEndTwice, "line_end_twice", "both ends of a line are drawn, so joints are hit twice", kHandWritten},
    {Fault::kLineStartMissing, "line_start_missing", "the first pixel of a line is left out",
     "liballeg/allegro5#318"},
    {Fault::kLineTies, "line_ties", "ties of a Bresenham line go to the next row",
     "aros-development-team/AROS PR 903"},
    {Fault::kLineAsParallelogram, "line_as_parallelogram", "the ends of a rectangular line follow an axis",
     "KhronosGroup/VK-GL-CTS#274"},
    {Fault::kLineWidthIgnored, "line_width_ignored", "all lines are 1 pixel wide", kHandWritten},
    {Fault::kOutlineOfPieces, "outline_of_pieces", "the triangles that clipping makes are outlined one by one",
     kHandWritten},
    {Fault::kPointSizeRounded, "point_size_rounded", "the size of a point is rounded to whole pixels", kHandWritten},
    {Fault::kPointsDroppedAtBorder, "points_dropped_at_border", "a point that reaches out of the viewport is dropped",
     kHandWritten},
    {Fault::kPointsBeyondVolume, "points_beyond_volume", "points outside of the volume are drawn", kHandWritten},
    {Fault::kPointCoordFlipped, "point_coord_flipped", "gl_PointCoord's t points up", kHandWritten},

    {Fault::kPerspectiveDepth, "perspective_depth", "depth is interpolated with perspective", kHandWritten},
    {Fault::kDepthOfPrimitive, "depth_of_primitive", "a primitive has one depth, as a painter sorts it",
     kHandWritten},
    {Fault::kClipDepthUndivided, "clip_depth_undivided", "clip-space z is interpolated, undivided by w",
     "bulletphysics/bullet3 PR 1439"},
    {Fault::kDepthRangeSorted, "depth_range_sorted", "minDepth and maxDepth change places if minDepth is greater",
     kHandWritten},
    {Fault::kDepthNotClamped, "depth_not_clamped", "depth clamp goes from 0 to 1, not to the viewport's range",
     kHandWritten},
    {Fault::kDepthCompareOffByEqual, "depth_compare_off_by_equal",
     "less is less or equal and so on, and the other way", kHandWritten},
    {Fault::kDepthWriteAlways, "depth_write_always", "depth is written although depth write is off", kHandWritten},
    {Fault::kDepthInHalfPrecision, "depth_in_half_precision", "depth passes through a float of 11 bits",
     "PCSX2/pcsx2#2980"},
    {Fault::kDepthComparedUnrounded, "depth_compared_unrounded",
     "depth is compared before it is rounded to the format", kHandWritten},
    {Fault::kDepthBoundsOfFragment, "depth_bounds_of_fragment", "depth bounds are held against the fragment's depth",
     kHandWritten},
    {Fault::kBiasSign, "bias_sign", "depth bias is subtracted", kHandWritten},
    {Fault::kBiasSlopeMissing, "bias_slope_missing", "the slope takes no part in the depth bias", kHandWritten},
    {Fault::kBiasDoubled, "bias_doubled", "the constant depth bias of a float format counts twice",
     "xemu-project/xemu PR 2240"},
    {Fault::kBiasUnitFixed, "bias_unit_fixed", "the constant depth bias of a float format is in units of 2^-24",
     "doitsujin/dxvk#2892"},
    {Fault::kBiasClampIgnored, "bias_clamp_ignored", "depth bias is not clamped", kHandWritten},

    {Fault::kAffineVaryings, "affine_varyings", "smooth varyings are interpolated without perspective", kHandWritten},
    {Fault::kNoperspectiveAsSmooth, "noperspective_as_smooth", "noperspective varyings are interpolated with it",
     kHandWritten},
    {Fault::kIntegerWeights, "integer_weights", "interpolation weights come from a division of integers",
     kHandWritten},
    {Fault::kCoarseWeights, "coarse_weights", "interpolation weights have 12 bits and do not add up to one",
     "lynx-family/skity PR 318"},
    {Fault::kWeightsSwapped, "weights_swapped", "two interpolation weights change places", kHandWritten},
    {Fault::kValuesAtPixelCorner, "values_at_pixel_corner", "varyings are evaluated at a pixel's corner",
     kHandWritten},
    {Fault::kValuesOneStepLate, "values_one_step_late", "varyings run a pixel ahead, beyond the end of the span",
     kHandWritten},
    {Fault::kCentroidAtCentre, "centroid_at_centre", "a centroid varying is evaluated at the centre all the same",
     kHandWritten},
    {Fault::kSampleAtCentre, "sample_at_centre", "a sample varying is evaluated at the centre all the same",
     kHandWritten},
    {Fault::kFragCoordW, "frag_coord_w", "gl_FragCoord.w is w instead of 1/w", "gfx-rs/wgpu#9106"},
    {Fault::kFragCoordAtCorner, "frag_coord_at_corner", "gl_FragCoord.xy are whole numbers", kHandWritten},
    {Fault::kNanVaryingDiscards, "nan_varying_discards", "a NaN varying takes the fragment away",
     "HansKristian-Work/vkd3d-proton#79"},
});

}  // namespace

std::span<const FaultEntry> catalogue() {
  return kCatalogue;
}

std::vector<std::string> fault_names() {
  std::vector<std::string> names;
  names.reserve(kCatalogue.size());
  for (const FaultEntry& entry : kCatalogue) names.emplace_back(entry.name);
  return names;
}

Result<Fault> fault_named(std::string_view name) {
  if (name == "none") return Fault::kNone;
  const auto* const found = std::ranges::find(kCatalogue, name, &FaultEntry::name);
  if (found != kCatalogue.end()) return found->fault;
  return failure(fmt::format("there is no fault '{}'", name),
                 format::suggestion(name, fault_names(), "the faults are none"));
}

}  // namespace fillrule::faults
