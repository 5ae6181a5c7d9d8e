#include "harness/report/packed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include "harness/report/unpack.h"

namespace fillrule::report {
namespace {

TEST(Base64, IsThatOfTheStandard) {
  const auto text = [](std::string_view plain) {
    return base64({reinterpret_cast<const uint8_t*>(plain.data()), plain.size()});
  };
  EXPECT_EQ(text(""), "");
  EXPECT_EQ(text("f"), "Zg==");
  EXPECT_EQ(text("fo"), "Zm8=");
  EXPECT_EQ(text("foobar"), "Zm9vYmFy");
}

TEST(Packer, BytesOfEqualWeightLieSideBySide) {
  Packer packer;
  packer.add_words(std::vector<uint32_t>{0x04030201, 0x40302010});
  packer.add_bytes(std::vector<uint8_t>{9});
  EXPECT_THAT(unpacked(packer.packed()), testing::ElementsAre(0x01, 0x10, 0x02, 0x20, 0x03, 0x30, 0x04, 0x40, 9));
}

TEST(Packer, EqualWordsLeaveZeros) {
  Packer packer;
  const std::vector<uint32_t> base{0x04030201, 7};
  packer.add_words(std::vector<uint32_t>{0x04030201, 6}, base);
  EXPECT_THAT(unpacked(packer.packed()), testing::ElementsAre(0, 1, 0, 0, 0, 0, 0, 0));
}

TEST(Packer, ThePayloadOfANanSurvives) {
  Packer packer;
  packer.add_floats(std::vector<float>{std::bit_cast<float>(0xffc12345U)});
  EXPECT_THAT(unpacked(packer.packed()), testing::ElementsAre(0x45, 0x23, 0xc1, 0xff));
}

}  // namespace
}  // namespace fillrule::report
