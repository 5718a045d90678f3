#include "rovio_sfm/sim/http/reply_fields.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

TEST(ReplyFields, AreLines) {
  ReplyFields fields;
  fields.Add("Port0", "80");
  fields.Add("Port1", "0");
  EXPECT_EQ(fields.ToText(), "Port0 = 80\nPort1 = 0\n");
}

TEST(ReplyFields, OfOneNameStayTogether) {
  ReplyFields fields;
  for (const char* name : {"a", "b", "c"}) {
    fields.Add("Name", name);
    fields.Add("Privilege", "0");
  }
  EXPECT_EQ(fields.ToText(),
            "Name = a\nName = b\nName = c\nPrivilege = 0\nPrivilege = 0\nPrivilege = 0\n");
}

TEST(RenderReply, MakesJavaScriptAndXml) {
  const auto script = RenderReply("a = \"b\"\n", Parameters::Parse("JsVar=v&OnJs=f"));
  EXPECT_EQ(script.body, "v=\"a = \\\"b\\\"\\n\";\nf(this);\n");
  const auto xml = RenderReply("a<b\n", Parameters::Parse("XML=x"));
  EXPECT_EQ(xml.content_type, "text/xml");
  EXPECT_EQ(xml.body, "<XML Name=\"x\">a&lt;b\n</XML>\n");
  EXPECT_EQ(RenderReply("a\n", Parameters::Parse("a=b")).body, "a\n");
}

}  // namespace
}  // namespace rovio_sfm::sim
