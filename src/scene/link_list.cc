#include "rovio_sfm/scene/link_list.h"

#include <array>
#include <cstdint>

namespace rovio_sfm {
namespace {

using Fields = std::array<uint32_t, 6>;

Fields FieldsOf(const FeatureLink& link) {
  return {link.a.session.value, link.a.frame, link.a.feature,
          link.b.session.value, link.b.frame, link.b.feature};
}

FeatureLink LinkOf(const Fields& fields) {
  return {{{fields[0]}, fields[1], fields[2]}, {{fields[3]}, fields[4], fields[5]}};
}

// Seven bits a byte, the lowest first; the eighth says that more follow. Steps forward are even,
// steps back odd, so that small ones of both kinds are short. Steps wrap as uint32_t does.
void AppendStep(uint32_t step, std::string* bytes) {
  const bool is_back = step >> 31 != 0;
  uint32_t left = is_back ? ~(step << 1) : step << 1;
  for (; left > 0x7f; left >>= 7) bytes->push_back(static_cast<char>((left & 0x7f) | 0x80));
  bytes->push_back(static_cast<char>(left));
}

uint32_t ReadStep(std::string::const_iterator* at) {
  uint32_t read = 0;
  for (int shift = 0;; shift += 7) {
    const auto byte = static_cast<uint8_t>(*(*at)++);
    read |= static_cast<uint32_t>(byte & 0x7f) << shift;
    if (byte < 0x80) break;
  }
  return (read & 1) != 0 ? ~(read >> 1) : read >> 1;
}

}  // namespace

LinkList::LinkList(const std::vector<FeatureLink>& links) : size_(links.size()) {
  Fields before{};
  for (const FeatureLink& link : links) {
    const Fields fields = FieldsOf(link);
    for (size_t i = 0; i < fields.size(); ++i) AppendStep(fields[i] - before[i], &steps_);
    before = fields;
  }
  steps_.shrink_to_fit();
}

std::vector<FeatureLink> LinkList::List() const {
  std::vector<FeatureLink> links;
  links.reserve(size_);
  Fields fields{};
  auto at = steps_.begin();
  while (at != steps_.end()) {
    for (uint32_t& field : fields) field += ReadStep(&at);
    links.push_back(LinkOf(fields));
  }
  return links;
}

}  // namespace rovio_sfm
