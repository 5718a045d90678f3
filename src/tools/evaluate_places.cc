#include "rovio_sfm/tools/evaluate_places.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "rovio_sfm/app/place_model_option.h"
#include "rovio_sfm/io/write_file.h"
#include "rovio_sfm/tools/place_trial.h"
#include "rovio_sfm/util/check_options.h"
#include "rovio_sfm/util/keep_memory.h"
#include "rovio_sfm/util/parse_arguments.h"

namespace rovio_sfm {
namespace {

struct Arguments {
  std::vector<std::string> queries, database, distractors;
  std::string model, out, truth = "poses", matrix;
  size_t stride = 1, distractor_stride = 1;
  int num_threads = 2;
  PlaceTrialOptions trial;
  bool mean_field = false;
  bool overwrite = false;
  FrontendOptions frontend;
  PlaceRecognizerOptions recognizer;
};

void Declare(Arguments* a, CLI::App* app) {
  app->add_option("--query", a->queries, "folders, or FOLDER@FIRST:LAST")->required();
  CLI::Option* database =
      app->add_option("--database", a->database, "folders that show the queries' places");
  app->add_option("--distractors", a->distractors, "folders that show none of them");
  app->add_option("--model", a->model, "place model; without: that of the package");
  app->add_option("--out", a->out, "folder for the results")->required();
  app->add_option("--truth", a->truth, "overlaps: overlaps.txt of a folder; poses: ground truth")
      ->check(CLI::IsMember({"overlaps", "poses"}));
  app->add_option("--matrix", a->matrix, "truth: a row per query; 1, 0, or -1 for not scored");
  app->add_option("--stride", a->stride, "every N-th image")->check(CLI::Range(1, 1000000));
  app->add_option("--distractor-stride", a->distractor_stride, "of the distractors")
      ->check(CLI::Range(1, 1000000));
  app->add_option("--features", a->frontend.extract.max_features, "most features of an image");
  app->add_option("--candidates", a->recognizer.candidates.max_candidates, "verified at a query");
  app->add_option("--min-score", a->recognizer.candidates.min_score, "below: none is verified");
  app->add_option("--ratio", a->recognizer.verify.pair.max_ratio, "of descriptors, in geometry");
  app->add_option("--min-inliers", a->recognizer.verify.pair.verify.min_inliers, "of geometry");
  app->add_flag("--prior", a->trial.use_prior, "with the motion prior, queries in their order");
  app->add_option("--self", a->trial.self_gap,
                  "instead of a database: the queries that come at least so many images before")
      ->check(CLI::Range(1, 1000000))
      ->excludes(database);
  app->add_flag("--scores", a->trial.keep_scores, "write the score of each query and place too");
  app->add_flag("--mean-field", a->mean_field, "the new place by mean field, not by samples");
  app->add_option("--threads", a->num_threads, "of extraction")->check(CLI::Range(1, 64));
  app->add_option("--seed", a->recognizer.seed, "of geometry");
  app->add_flag("--overwrite", a->overwrite, "replace the results of an earlier run");
}

void CheckArguments(Arguments* arguments) {
  const bool is_self = arguments->trial.self_gap > 0;
  if (arguments->database.empty() && !is_self) {
    throw std::runtime_error("--database: expected folders, or --self");
  }
  if (arguments->mean_field) {
    arguments->recognizer.fabmap.new_place_model = NewPlaceModel::kMeanField;
  }
  std::string error;
  if (!IsValid(arguments->frontend, &error) || !IsValid(arguments->recognizer, &error)) {
    throw std::runtime_error(error);
  }
  const std::filesystem::path summary = std::filesystem::path(arguments->out) / "summary.json";
  if (std::filesystem::exists(summary) && !arguments->overwrite) {
    throw std::runtime_error(summary.string() + " exists; give --overwrite to replace it");
  }
}

// Folders as they were read, and all their images one after the other.
struct Side {
  std::vector<PlaceImages> folders;
  std::vector<PlaceImage> images;
};

Side ReadSide(const std::vector<std::string>& folders, size_t stride, const Arguments& arguments,
              uint32_t* num_folders) {
  Side side;
  for (const std::string& folder : folders) {
    side.folders.push_back(ReadPlaceImages(folder, stride));
    for (PlaceImage& image : ExtractPlaceImages(&side.folders.back(), (*num_folders)++,
                                                arguments.frontend, arguments.num_threads)) {
      side.images.push_back(std::move(image));
    }
  }
  return side;
}

// What a query does not know yet is no answer.
void HideUnknown(const std::vector<PlaceImage>& queries, size_t self_gap, PlaceTruth* truth) {
  for (size_t i = 0; i < queries.size(); ++i) {
    for (size_t j = 0; j < queries.size(); ++j) {
      if (!KnowsImage(queries, i, j, self_gap)) (*truth)[i][j] = PlaceLabel::kNegative;
    }
  }
}

TruthSource SourceOf(const Arguments& arguments) {
  return arguments.truth == "poses" ? TruthSource::kPoses : TruthSource::kOverlaps;
}

PlaceTruth TruthOf(const Arguments& arguments, const Side& queries, const Side& database,
                   size_t num_distractors) {
  if (!arguments.matrix.empty()) {
    return ReadPlaceTruth(arguments.matrix, queries.images.size(), database.images.size(),
                          num_distractors);
  }
  return FindPlaceTruth(queries.folders, database.folders, num_distractors, SourceOf(arguments));
}

bool HasPositive(const PlaceTruth& truth) {
  return std::any_of(truth.begin(), truth.end(), [](const std::vector<PlaceLabel>& row) {
    return std::count(row.begin(), row.end(), PlaceLabel::kPositive) > 0;
  });
}

// Without a query that could be answered rightly every figure would mean nothing.
void RequirePositive(const Arguments& arguments, const Side& queries, const Side& database,
                     const PlaceTruth& truth) {
  if (HasPositive(truth)) return;
  const std::string why = arguments.matrix.empty()
                              ? WhyNoPositive(queries.folders, database.folders,
                                              arguments.trial.self_gap, SourceOf(arguments))
                              : arguments.matrix + " has no 1 that counts";
  throw std::runtime_error("no query has a place that is right, so nothing can be measured: " +
                           why);
}

struct Method {
  std::string name;
  const std::vector<std::optional<PlaceAnswer>>* answers;
  PlaceCurve curve;
};

nlohmann::ordered_json CurveJson(const PlaceCurve& curve) {
  return {{"precision", curve.precision},
          {"recall", curve.recall},
          {"right", curve.num_right},
          {"wrong", curve.num_wrong},
          {"not_scored", curve.num_between},
          {"area_under_curve", curve.area},
          {"strict_recall", curve.strict_recall},
          {"strict_area_under_curve", curve.strict_area},
          {"recall_at_full_precision", curve.recall_at_full_precision},
          {"recall_at_95_precision", curve.recall_at_95_precision},
          {"strict_recall_at_full_precision", curve.strict_recall_at_full_precision},
          {"strict_recall_at_95_precision", curve.strict_recall_at_95_precision}};
}

nlohmann::ordered_json CountersJson(const PlaceCounters& counters) {
  return {{"queries", counters.queries},
          {"low_score", counters.low_score},
          {"candidates", counters.candidates},
          {"refused_geometry", counters.refused_geometry},
          {"refused_spread", counters.refused_spread},
          {"outdone", counters.outdone},
          {"matches", counters.matches},
          {"matched_queries", counters.matched_queries},
          {"pairs", counters.pairs}};
}

nlohmann::ordered_json SummaryJson(const Arguments& arguments, const std::vector<Method>& methods,
                                   const PlaceTrial& trial, const PlaceModel& model,
                                   size_t num_places) {
  nlohmann::ordered_json summary;
  summary["query"] = arguments.queries;
  summary["database"] = arguments.database;
  summary["distractors"] = arguments.distractors;
  summary["truth"] = arguments.matrix.empty() ? arguments.truth : arguments.matrix;
  summary["stride"] = arguments.stride;
  summary["prior"] = arguments.trial.use_prior;
  summary["self_gap"] = arguments.trial.self_gap;
  summary["model"] = model.provenance;
  summary["words"] = model.vocabulary.NumWords();
  summary["places"] = num_places;
  summary["queries"] = methods.front().curve.num_queries;
  summary["queries_with_positive"] = methods.front().curve.num_positive;
  for (const Method& method : methods) summary[method.name] = CurveJson(method.curve);
  summary["counters"] = CountersJson(trial.counters);
  summary["cpu_ms_per_query"] = {
      {"words", trial.words_ms}, {"fabmap", trial.fabmap_ms}, {"verify", trial.verify_ms}};
  summary["bytes_per_place"] = trial.bytes_per_place;
  return summary;
}

std::string CurvesText(const std::vector<Method>& methods) {
  std::ostringstream text;
  text << "method,threshold,precision,recall\n";
  for (const Method& method : methods) {
    for (const PlaceOperatingPoint& point : method.curve.points) {
      text << method.name << "," << point.threshold << "," << point.precision << "," << point.recall
           << "\n";
    }
  }
  return text.str();
}

std::string AnswersText(const std::vector<Method>& methods, const std::vector<PlaceImage>& queries,
                        const std::vector<PlaceImage>& database, const PlaceTruth& truth) {
  const char* const names[] = {"wrong", "not_scored", "right"};
  std::ostringstream text;
  text << "query,method,answer,score,label\n";
  for (size_t i = 0; i < queries.size(); ++i) {
    for (const Method& method : methods) {
      const std::optional<PlaceAnswer>& answer = (*method.answers)[i];
      text << queries[i].name << "," << method.name << ",";
      if (!answer) text << ",,none\n";
      if (!answer) continue;
      text << database[answer->other].name << "," << answer->score << ","
           << names[static_cast<size_t>(truth[i][answer->other])] << "\n";
    }
  }
  return text.str();
}

std::string ScoresText(const PlaceTrial& trial, const std::vector<PlaceImage>& queries,
                       const std::vector<PlaceImage>& database) {
  std::ostringstream text;
  text << "query";
  for (const PlaceImage& image : database) text << "," << image.name;
  text << "\n";
  for (size_t i = 0; i < queries.size(); ++i) {
    text << queries[i].name;
    for (const double score : trial.scores[i]) text << "," << score;
    text << "\n";
  }
  return text.str();
}

void Evaluate(const Arguments& arguments, std::ostream& out) {
  const std::shared_ptr<const PlaceModel> model = ReadPlaceModel(arguments.model);
  uint32_t num_folders = 0;
  const Side queries = ReadSide(arguments.queries, arguments.stride, arguments, &num_folders);
  Side database = ReadSide(arguments.database, arguments.stride, arguments, &num_folders);
  const Side distractors =
      ReadSide(arguments.distractors, arguments.distractor_stride, arguments, &num_folders);
  const size_t self_gap = arguments.trial.self_gap;
  if (self_gap > 0) database = queries;
  PlaceTruth truth = TruthOf(arguments, queries, database, distractors.images.size());
  if (self_gap > 0) HideUnknown(queries.images, self_gap, &truth);
  RequirePositive(arguments, queries, database, truth);
  std::filesystem::create_directories(arguments.out);
  database.images.insert(database.images.end(), distractors.images.begin(),
                         distractors.images.end());
  const PlaceTrial trial =
      RunPlaceTrial(queries.images, database.images, model, arguments.recognizer, arguments.trial);
  std::vector<Method> methods{{"fabmap", &trial.fabmap, {}},
                              {"fabmap_verified", &trial.verified, {}},
                              {"tf_idf", &trial.tf_idf, {}}};
  for (Method& method : methods) method.curve = MeasurePlaceCurve(*method.answers, truth);
  const std::filesystem::path folder(arguments.out);
  const Overwrite overwrite = arguments.overwrite ? Overwrite::kAllow : Overwrite::kRefuse;
  const std::string summary =
      SummaryJson(arguments, methods, trial, *model, database.images.size()).dump(2) + "\n";
  WriteFile(folder / "curves.csv", CurvesText(methods), overwrite);
  WriteFile(folder / "answers.csv", AnswersText(methods, queries.images, database.images, truth),
            overwrite);
  if (arguments.trial.keep_scores) {
    WriteFile(folder / "scores.csv", ScoresText(trial, queries.images, database.images), overwrite);
  }
  WriteFile(folder / "summary.json", summary, overwrite);
  out << "wrote " << std::filesystem::absolute(folder / "summary.json").string() << "\n" << summary;
}

}  // namespace

int EvaluatePlacesCommand(int argc, const char* const* argv, std::ostream& out) {
  CLI::App app("Measures place recognition: precision and recall, before and after geometry");
  Arguments arguments;
  Declare(&arguments, &app);
  if (const std::optional<int> status = ParseArguments(&app, argc, argv, out)) return *status;
  cv::setNumThreads(1);  // the threads are ours
  KeepFreedMemory();
  CheckArguments(&arguments);
  Evaluate(arguments, out);
  return 0;
}

}  // namespace rovio_sfm
