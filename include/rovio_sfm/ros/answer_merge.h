#pragma once

#include <rovio_sfm/MergeSessions.h>
#include <rovio_sfm/UnmergeSession.h>

#include "rovio_sfm/app/mapping_engine.h"

// What the services merge_sessions and unmerge_session do. Malformed requests, unknown sessions and
// refusals are answered with the reason, and change nothing.
namespace rovio_sfm {

MergeSessionsResponse AnswerMerge(const MergeSessionsRequest& request, MappingEngine* engine);
UnmergeSessionResponse AnswerUnmerge(const UnmergeSessionRequest& request, MappingEngine* engine);

}  // namespace rovio_sfm
