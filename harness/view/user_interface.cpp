#include "harness/view/user_interface.h"

#include <GL/gl.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "harness/view/actions.h"

namespace fillrule::view {
namespace {

constexpr ImGuiWindowFlags kBare = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                   ImGuiWindowFlags_NoNav;
constexpr ImU32 kMark = IM_COL32(255, 255, 0, 255);
constexpr float kTitleHeight = 18;

ImVec2 vector_of(int x, int y) {
  return {static_cast<float>(x), static_cast<float>(y)};
}

// Into a texture of the same size, if it is one.
void upload(unsigned texture, const Image& image, bool same_size) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  const auto width = static_cast<int>(image.width);
  const auto height = static_cast<int>(image.height);
  if (same_size) {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    return;
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
}

// Text of our own, which no format may be read in.
void text(const std::string& line) {
  ImGui::TextUnformatted(line.data(), line.data() + line.size());
}

}  // namespace

UserInterface::UserInterface() {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  ImGui::StyleColorsDark();
  ImGui::GetStyle().WindowBorderSize = 0;
  ImGui_ImplOpenGL3_Init("#version 130");
}

UserInterface::~UserInterface() {
  for (const Texture& texture : textures_) glDeleteTextures(1, &texture.name);
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void UserInterface::resize(int width, int height) {
  width_ = width;
  height_ = height;
}

void UserInterface::handle(const Input& input, Session& session) {
  const bool in_bars = mouse_.y < kBarHeight || mouse_.y >= height_ - kStatusHeight;
  const auto button = static_cast<size_t>(input.button);
  switch (input.kind) {
    case Input::Kind::kMove:
      mouse_ = {input.x, input.y};
      break;
    case Input::Kind::kPress:
      is_down_[button] = was_pressed_[button] = true;
      if (in_bars) return;
      break;
    case Input::Kind::kRelease:
      is_down_[button] = false;
      break;
    case Input::Kind::kWheel:
      if (in_bars) return;
      break;
    default:
      break;
  }
  session.handle(input);
}

void UserInterface::draw_buttons(Session& session) {
  for (const ActionRow& action : actions()) {
    if (action.button.empty()) continue;
    if (ImGui::Button(std::string(action.button).c_str())) session.do_action(action, {});
    if (ImGui::IsItemHovered()) {
      ImGui::BeginTooltip();
      text(std::string(action.key) + ": " + std::string(action.help));
      ImGui::EndTooltip();
    }
    ImGui::SameLine();
  }
}

void UserInterface::draw_pane(const Session::Pane& pane, const Mismatch* mismatch, Texture& texture) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddText(vector_of(pane.room.x + 4, pane.room.y - static_cast<int>(kTitleHeight)),
               ImGui::GetColorU32(ImGuiCol_Text), pane.title.c_str());
  if (pane.image == nullptr) return;
  if (texture.name == 0) glGenTextures(1, &texture.name);
  if (texture.stamp != pane.stamp) {
    const glm::uvec2 size(pane.image->width, pane.image->height);
    upload(texture.name, *pane.image, texture.size == size);
    texture.size = size;
    texture.stamp = pane.stamp;
  }
  const Rect& rect = pane.placement.rect;
  const Rect& room = pane.room;
  list.PushClipRect(vector_of(room.x, room.y), vector_of(room.x + room.width, room.y + room.height));
  // ImGui's texture is whatever its backend takes for one: OpenGL's name.
  // NOLINTNEXTLINE(performance-no-int-to-ptr)
  list.AddImage(reinterpret_cast<ImTextureID>(static_cast<uintptr_t>(texture.name)), vector_of(rect.x, rect.y),
                vector_of(rect.x + rect.width, rect.y + rect.height));
  if (mismatch != nullptr) {
    const int scale = pane.placement.scale;
    const int x = rect.x + static_cast<int>(mismatch->x) * scale;
    const int y = rect.y + static_cast<int>(mismatch->y) * scale;
    constexpr int kRoom = 3;
    list.AddRect(vector_of(x - kRoom, y - kRoom), vector_of(x + scale + kRoom, y + scale + kRoom), kMark);
  }
  list.PopClipRect();
}

void UserInterface::draw_help() {
  ImGui::SetNextWindowPos({8, static_cast<float>(kBarHeight) + 8});
  ImGui::Begin("help", nullptr, kBare | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
  // In two halves side by side, each of keys and what they do.
  constexpr float kKeysWidth = 210;
  constexpr float kHelpWidth = 340;
  const std::vector<HelpLine> lines = help_lines();
  const size_t rows = (lines.size() + 1) / 2;
  for (size_t i = 0; i < lines.size(); ++i) {
    const float left = i < rows ? 8 : 8 + kKeysWidth + kHelpWidth;
    const float top = 8 + static_cast<float>(i < rows ? i : i - rows) * ImGui::GetTextLineHeightWithSpacing();
    ImGui::SetCursorPos({left, top});
    text(lines[i].keys);
    ImGui::SetCursorPos({left + kKeysWidth, top});
    text(std::string(lines[i].help));
  }
  ImGui::End();
}

void UserInterface::draw(Session& session, double seconds) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = vector_of(width_, height_);
  io.DeltaTime = std::max(static_cast<float>(seconds), 1e-4F);
  io.MousePos = {static_cast<float>(mouse_.x), static_cast<float>(mouse_.y)};
  for (size_t i = 0; i < is_down_.size(); ++i) io.MouseDown[i] = is_down_[i] || was_pressed_[i];
  was_pressed_ = {};

  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({io.DisplaySize.x, kBarHeight - kTitleHeight});
  ImGui::Begin("buttons", nullptr, kBare | ImGuiWindowFlags_NoBackground);
  draw_buttons(session);
  ImGui::End();
  const std::vector<Session::Pane> panes = session.panes();
  textures_.resize(panes.size());
  for (size_t i = 0; i < panes.size(); ++i) draw_pane(panes[i], session.mismatch(), textures_[i]);
  ImGui::GetBackgroundDrawList()->AddText(vector_of(4, height_ - kStatusHeight + 5),
                                          ImGui::GetColorU32(ImGuiCol_Text), session.status().c_str());
  if (session.shows_help()) draw_help();
  ImGui::Render();
  glViewport(0, 0, width_, height_);
  glClearColor(0.16F, 0.16F, 0.17F, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace fillrule::view
