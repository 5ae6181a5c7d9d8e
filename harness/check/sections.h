// The sections of the Vulkan specification that decide about rasterization: what a case's `spec` may name.
#pragma once

#include <array>
#include <string_view>

namespace fillrule::check {

// By chapter. A section of Shader Built-Ins is "Built-In Variables: " and the variable.
inline constexpr std::array<std::string_view, 59> kSections{
    // Fundamentals
    "Floating-Point Computation", "Fixed-Point Data Conversions",
    // Invariance
    "Repeatability", "Multi-pass Algorithms", "Invariance Rules",
    // Render Pass
    "Clear Values", "Render Area",
    // Pipelines
    "Graphics Pipelines", "Dynamic State",
    // Shaders
    "Interpolation Decorations", "Fragment Shaders",
    // Shader Interfaces
    "Interface Matching", "Built-In Variables: FragCoord", "Built-In Variables: FrontFacing",
    "Built-In Variables: PointCoord", "Built-In Variables: PointSize", "Built-In Variables: PrimitiveId",
    "Built-In Variables: Position", "Built-In Variables: ClipDistance", "Built-In Variables: CullDistance",
    // Drawing Commands: restart, vertex offset and index types have no section of their own
    "Drawing Commands", "Primitive Topologies", "Point Lists", "Line Lists", "Line Strips", "Triangle Lists",
    "Triangle Strips", "Triangle Fans", "Primitive Order", "Programmable Primitive Shading",
    // Fixed-Function Vertex Post-Processing
    "Flat Shading", "Primitive Clipping", "Clipping Shader Outputs", "Coordinate Transformations",
    "Controlling the Viewport",
    // Rasterization
    "Rasterization", "Rasterization Order", "Multisampling", "Sample Shading", "Barycentric Interpolation", "Points",
    "Basic Point Rasterization", "Line Segments", "Basic Line Segment Rasterization",
    "Bresenham Line Segment Rasterization", "Polygons", "Basic Polygon Rasterization", "Polygon Mode", "Depth Bias",
    // Fragment Operations
    "Scissor Test", "Sample Mask Test", "Depth Test", "Depth Clamping and Range Adjustment", "Depth Comparison",
    "Depth Attachment Writes", "Depth Bounds Test",
    // Image Operations
    "Wrapping Operation", "Texel Filtering", "Level-of-Detail Operation"};

}  // namespace fillrule::check
