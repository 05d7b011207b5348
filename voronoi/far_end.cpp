#include "../exact/floating_environment.hpp"
#include "of_metric.hpp"

namespace signum {

Sign far_end(Metric metric, WeightIs weight_is, const Site& a, const Site& b, const Site& apex,
             EndOfEdge end) {
    const exact::IeeeEnvironment environment;
    return with_metric(metric,
                       [&]<class M>(M) { return far_end_in<M>(weight_is, a, b, apex, end); });
}

}  // namespace signum
