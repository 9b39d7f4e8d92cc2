@file:Suppress("ClassName")

package jason.stdlib.argo

/** `.argo.port(…)`: see [argo.port]. */
class port : argo.port()

/** `.argo.limit(…)`: see [argo.limit]. */
class limit : argo.limit()

/** `.argo.percepts(…)`: see [argo.percepts]. */
class percepts : argo.percepts()

/** `.argo.act(…)`: see [argo.act]. */
class act : argo.act()

/** `.argo.change_filter(…)`: see [argo.change_filter]. */
class change_filter : argo.change_filter()

/** `.argo.filter(…)`: see [argo.change_filter]. */
class filter : argo.change_filter()

/** `.argo.explain(…)`: see [argo.explain]. */
class explain : argo.explain()

/** `.argo.age(…)`: see [argo.age]. */
class age : argo.age()

/** `.argo.can(…)`: see [argo.can]. */
class can : argo.can()

/** `.argo.ports(…)`: see [argo.ports]. */
class ports : argo.ports()

/** `.argo.skew(…)`: see [argo.skew]. */
class skew : argo.skew()

/** `.argo.record(…)`: see [argo.record]. */
class record : argo.record()

/** `.argo.reload(…)`: see [argo.reload]. */
class reload : argo.reload()
