planning-rejected = { $reason } { $count }
planning-no-start-configuration =
    no start configuration with sensor axis { $axis } along gravity: rejected { $kinds ->
        [0] nothing, no candidate
       *[other] { $rejected }
    }. Move what is in the way, reduce the payload box, limits.clearance_m or limits.self_clearance_m, or search more (--effort), and plan again.
planning-no-start-configuration-near =
    no start configuration with sensor axis { $axis } along gravity: rejected { $kinds ->
        [0] nothing, no candidate
       *[other] { $rejected }
    }; the best clearance met was { FIXED($best_clearance_m, digits: 3) } m to "{ $nearest }". Move what is in the way, reduce the payload box, limits.clearance_m or limits.self_clearance_m, or search more (--effort), and plan again.
planning-other-axes = { $refusal } There is a plan for the other sensor axes: --axes { $axes }.
