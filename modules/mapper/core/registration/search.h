#pragma once

#include "modules/mapper/core/registration/agreement.h"
#include "modules/mapper/core/registration/consensus.h"
#include "modules/mapper/core/registration/icp.h"
#include "modules/mapper/core/registration/verdict.h"

namespace scanway::registration {

/// A pose that survived a short refinement, with how well the scans agree there.
struct Candidate {
  Pose T_target_source = Pose::Identity();
  Evidence evidence;
};

/// Which matches are asked: those that answer each other; the nearest of each source keypoint; and those of the
/// target's too, of which many more poses are tried.
enum class SearchWidth { mutual, wide, thorough };

/// The bounds of the search about a tracker's rotation: three deviations, and never less than what a tracker may be
/// off by near iron or after a knock.
RotationBounds bounds_of(const OrientationPrior& prior);

/// Distinct poses between the sensors' centres at which the scans may be registered, the most likely first: matches of
/// features, their hypotheses, each refined by a short ICP and ranked by overlap and free space.
std::vector<Candidate> find_candidates(const PreparedScan::Data& source, const PreparedScan::Data& target,
                                       const std::optional<RotationBounds>& bounds, SearchWidth width,
                                       StageListener* stages);

/// The last ICP from a candidate's pose, on all chosen surfaces.
IcpResult refine_finely(const PreparedScan::Data& source, const PreparedScan::Data& target,
                        const Pose& T_target_source);

/// What speaks for and against the result of an ICP; all but the margin.
Evidence evidence_of(const PreparedScan::Data& source, const PreparedScan::Data& target, const IcpResult& icp);

/// Sorts by rank and keeps of like poses the best.
std::vector<Candidate> rank_candidates(std::vector<Candidate> all);

/// How much less likely the best of the other distinct candidates is than `best`, in the verdict's terms.
double margin_to_others(const Candidate& best, const std::vector<Candidate>& others);

}  // namespace scanway::registration
