#include "rovio_sfm/sim/http/command.h"

// The camera's settings. A guest may call them, and nothing happens: the inner call wants an
// administrator, and its refusal is dropped. Every reply is empty, also for bad values.
namespace rovio_sfm::sim {
namespace {

template <typename Setter>
void Store(const CommandCall& call, std::string_view parameter, Setter setter) {
  if (call.parameters.Get(parameter).empty()) return;
  if (call.caller.privilege < Privilege::kAdmin) return;
  // The firmware's number reader takes text without digits for 0.
  const long value = call.parameters.GetLong(parameter).value_or(0);
  call.context.settings.With([&](RobotSettings& settings) { setter(settings, value); });
}

void ChangeResolution(const CommandCall& call, CommandReply*) {
  Store(call, "ResType", [](RobotSettings& settings, long v) { settings.SetResolution(v); });
}

void ChangeCompressRatio(const CommandCall& call, CommandReply*) {
  Store(call, "Ratio", [](RobotSettings& settings, long v) { settings.SetCompressionRatio(v); });
}

void ChangeFramerate(const CommandCall& call, CommandReply*) {
  Store(call, "Framerate", [](RobotSettings& settings, long v) { settings.SetFrameRate(v); });
}

void ChangeBrightness(const CommandCall& call, CommandReply*) {
  Store(call, "Brightness", [](RobotSettings& settings, long v) { settings.SetBrightness(v); });
}

void ChangeSpeakerVolume(const CommandCall& call, CommandReply*) {
  Store(call, "SpeakerVolume",
        [](RobotSettings& settings, long v) { settings.speaker_volume = v; });
}

void ChangeMicVolume(const CommandCall& call, CommandReply*) {
  Store(call, "MicVolume", [](RobotSettings& settings, long v) { settings.mic_volume = v; });
}

// Not behind the trap above: guests may set the mains frequency.
void SetCamera(const CommandCall& call, CommandReply*) {
  const long value = call.parameters.GetLong("Frequency").value_or(0);
  if (value != 0 && value != 50 && value != 60) return;
  call.context.settings.With([&](RobotSettings& s) { s.mains_frequency_hz = value; });
}

void GetCamera(const CommandCall& call, CommandReply* reply) {
  reply->fields.Add("Frequency", std::to_string(call.context.settings.Copy().mains_frequency_hz));
}

void DropData(const CommandCall& call, CommandReply* reply) {
  const std::string path =
      call.parameters.Has("Path") ? call.parameters.Get("Path") : "/GetData.cgi";
  const int found = call.context.streams.Drop(path, call.parameters.Get("Query"));
  reply->fields.Add("Found", std::to_string(found));
}

}  // namespace

std::vector<Command> CameraCommands() {
  return {{"ChangeResolution.cgi", NeedsUser, ChangeResolution},
          {"ChangeCompressRatio.cgi", NeedsUser, ChangeCompressRatio},
          {"ChangeFramerate.cgi", NeedsUser, ChangeFramerate},
          {"ChangeBrightness.cgi", NeedsUser, ChangeBrightness},
          {"ChangeSpeakerVolume.cgi", NeedsUser, ChangeSpeakerVolume},
          {"ChangeMicVolume.cgi", NeedsUser, ChangeMicVolume},
          {"SetCamera.cgi", NeedsUser, SetCamera},
          {"GetCamera.cgi", NeedsUser, GetCamera},
          {"DropData.cgi", NeedsUser, DropData}};
}

}  // namespace rovio_sfm::sim
