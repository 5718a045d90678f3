#include "rovio_sfm/app/write_model_files.h"

#include <stdexcept>
#include <string>

#include "rovio_sfm/io/export_bundler.h"
#include "rovio_sfm/io/export_colmap.h"
#include "rovio_sfm/io/export_colmap_database.h"
#include "rovio_sfm/io/export_nvm.h"
#include "rovio_sfm/io/undistort_image.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

namespace fs = std::filesystem;

const char* const kPictures = "images";

class ModelWriter {
 public:
  ModelWriter(fs::path folder, Overwrite overwrite)
      : folder_(fs::absolute(folder)), overwrite_(overwrite) {}

  void Write(const std::string& name, const std::string& content) {
    WriteOne(name, content);
    written_.paths.push_back(folder_ / name);
  }

  void WritePictures(const MapModel& model, const PictureSource& pictures, bool undistorted) {
    for (const ModelImage& image : model.images) {
      const auto picture = pictures ? pictures(image) : nullptr;
      if (picture == nullptr) {
        written_.missing_pictures.insert(image.id);
        continue;
      }
      const std::vector<uint8_t> bytes =
          undistorted ? Undistorted(*picture, image, model) : *picture;
      const std::string name = undistorted ? UndistortedName(image.name) : image.name;
      WriteOne(kPictures + ("/" + name), {bytes.begin(), bytes.end()});
      written_.pictures.push_back(folder_ / kPictures / name);
    }
    if (!written_.pictures.empty()) written_.paths.push_back(folder_ / kPictures);
  }

  WrittenFiles Take() { return std::move(written_); }

 private:
  void WriteOne(const std::string& name, const std::string& content) {
    fs::create_directories((folder_ / name).parent_path());
    WriteFile(folder_ / name, content, overwrite_);
  }

  static std::vector<uint8_t> Undistorted(const std::vector<uint8_t>& picture,
                                          const ModelImage& image, const MapModel& model) {
    try {
      return UndistortImage(picture, model.cameras[image.camera]);
    } catch (const std::exception& error) {
      throw std::runtime_error("picture of frame " + image.id.ToString() + ": " + error.what());
    }
  }

  fs::path folder_;
  Overwrite overwrite_;
  WrittenFiles written_;
};

void WriteColmap(const std::vector<NamedFile>& files, const MapModel& model, ModelWriter* writer) {
  for (const NamedFile& file : files) writer->Write("sparse/0/" + file.name, file.content);
  writer->Write("database.db", ColmapDatabaseBytes(model));
}

void WriteFormat(const MapModel& model, MapFormat format, ModelWriter* writer) {
  switch (format) {
    case MapFormat::kColmap:
      return WriteColmap(ColmapBinaryFiles(model), model, writer);
    case MapFormat::kColmapText:
      return WriteColmap(ColmapTextFiles(model), model, writer);
    case MapFormat::kNvm:
      return writer->Write("model.nvm", NvmText(model, kPictures));
    case MapFormat::kBundler:
      for (const NamedFile& file : BundlerFiles(model, kPictures)) {
        writer->Write(file.name, file.content);
      }
      return;
    default:
      ROVIO_CHECK(false, "the format needs no model");
  }
}

}  // namespace

WrittenFiles WriteModelFiles(const MapModel& model, MapFormat format, const PictureSource& pictures,
                             const fs::path& folder, Overwrite overwrite) {
  ModelWriter writer(folder / MainPathOf(format), overwrite);
  WriteFormat(model, format, &writer);
  const bool undistorted = format == MapFormat::kBundler || format == MapFormat::kNvm;
  writer.WritePictures(model, pictures, undistorted);
  return writer.Take();
}

}  // namespace rovio_sfm
