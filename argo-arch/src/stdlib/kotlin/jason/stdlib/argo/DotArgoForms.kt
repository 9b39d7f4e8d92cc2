package jason.stdlib.argo

/** `.argo.port(…)`: see [argo.port]. */
@Suppress("ClassName")
class port : argo.port()

/** `.argo.limit(…)`: see [argo.limit]. */
@Suppress("ClassName")
class limit : argo.limit()

/** `.argo.percepts(…)`: see [argo.percepts]. */
@Suppress("ClassName")
class percepts : argo.percepts()

/** `.argo.act(…)`: see [argo.act]. */
@Suppress("ClassName")
class act : argo.act()

/** `.argo.change_filter(…)`: see [argo.change_filter]. */
@Suppress("ClassName")
class change_filter : argo.change_filter()

/** `.argo.filter(…)`: see [argo.change_filter]. */
@Suppress("ClassName")
class filter : argo.change_filter()

/** `.argo.explain(…)`: see [argo.explain]. */
@Suppress("ClassName")
class explain : argo.explain()

/** `.argo.age(…)`: see [argo.age]. */
@Suppress("ClassName")
class age : argo.age()

/** `.argo.can(…)`: see [argo.can]. */
@Suppress("ClassName")
class can : argo.can()

/** `.argo.ports(…)`: see [argo.ports]. */
@Suppress("ClassName")
class ports : argo.ports()

/** `.argo.skew(…)`: see [argo.skew]. */
@Suppress("ClassName")
class skew : argo.skew()

/** `.argo.record(…)`: see [argo.record]. */
@Suppress("ClassName")
class record : argo.record()
