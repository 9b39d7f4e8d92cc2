package jason.stdlib

/** `.port(…)`: see [argo.port]. */
@Suppress("ClassName")
class port : argo.port()

/** `.limit(…)`: see [argo.limit]. */
@Suppress("ClassName")
class limit : argo.limit()

/** `.percepts(…)`: see [argo.percepts]. */
@Suppress("ClassName")
class percepts : argo.percepts()

/** `.act(…)`: see [argo.act]. */
@Suppress("ClassName")
class act : argo.act()

/** `.change_filter(…)`: see [argo.change_filter]. */
@Suppress("ClassName")
class change_filter : argo.change_filter()

/** `.filter(…)`: see [argo.change_filter]. */
@Suppress("ClassName")
class filter : argo.change_filter()

/** `.explain(…)`: see [argo.explain]. */
@Suppress("ClassName")
class explain : argo.explain()

/** `.age(…)`: see [argo.age]. */
@Suppress("ClassName")
class age : argo.age()

/** `.can(…)`: see [argo.can]. */
@Suppress("ClassName")
class can : argo.can()

/** `.ports(…)`: see [argo.ports]. */
@Suppress("ClassName")
class ports : argo.ports()

/** `.skew(…)`: see [argo.skew]. */
@Suppress("ClassName")
class skew : argo.skew()

/** `.record(…)`: see [argo.record]. */
@Suppress("ClassName")
class record : argo.record()
