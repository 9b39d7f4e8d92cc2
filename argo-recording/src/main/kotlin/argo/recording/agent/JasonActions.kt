package argo.recording.agent

import jason.asSemantics.ArithFunction

/** How an internal action or a function of Jason depends on the world outside of its agent, or changes that world. */
internal enum class Nature {
    /** The result depends only on the agent, and nothing else changes. A replay carries the action out again. */
    PURE,

    /**
     * The action's messages pass the [argo.boundary.Boundary]. In a fleet, its intention waits until the messages have arrived. A replay
     * carries the action out again, and makes the intention wait as it waited in the recording.
     */
    SENDING,

    /**
     * The action's messages, percepts and timers pass the [argo.boundary.Boundary] and the [Keeper], which a replay provides. A replay
     * carries the action out again.
     */
    BOUNDARY,

    /** The result comes from a clock, chance, the disk or the infrastructure. A replay takes the recorded result. */
    INPUT,

    /** The action changes files, agents or the infrastructure. A replay takes the recorded result without carrying the action out. */
    EFFECT,
}

/**
 * The [Nature] of each internal action and function of Jason 3.2.1 and 3.3.0, by its class. Recordings and replays refuse all other code of
 * Jason, and name it.
 */
internal object JasonActions {
    private const val ACTIONS = "jason.stdlib."
    private const val FUNCTIONS = "jason.functions."

    private val actions: Map<String, Nature> = mapOf(
        Nature.PURE to """
            abolish add_annot add_nested_source add_plan asserta assertz atom belief concat copy_term count current_intention delete desire
            difference done drop_all_desires drop_all_events drop_all_intentions drop_desire drop_event drop_future_intention
            drop_intention empty eval fail fail_goal findall foreach fork get_src_info ground if_then_else include intend intention
            internal_action intersection join length list list_plans list_rules literal log loop lower_case max member min my_name
            namespace namespace_get_prop namespace_set_prop nth number plan_label prefix print print_unifier printf println puts range
            relevant_plan relevant_plans relevant_rules remove_plan remove_source_annot rename_apart replace resume reverse
            set_random_seed setof signal sort string structure sublist substring succeed_goal suffix suspend suspended term2string type
            union upper_case verbose
            map.clear map.copy map.create map.get map.key map.put map.remove map.value
            queue.add queue.add_all queue.clear queue.copy queue.create queue.head queue.remove queue.to_list
            set.add set.add_all set.clear set.copy set.create set.difference set.intersection set.remove set.to_list set.union
        """,
        Nature.SENDING to "broadcast send",
        Nature.BOUNDARY to """
            at perceive wait
            act age can change_filter explain filter limit percepts port ports record reload skew
            argo.act argo.age argo.can argo.change_filter argo.explain argo.filter argo.limit argo.percepts argo.port argo.ports
            argo.record argo.reload argo.skew
        """, // all lines except the first: ARGO's own actions, by other names
        Nature.INPUT to "all_names date df_search list_files nano_time random shuffle time version",
        Nature.EFFECT to "clone create_agent df_deregister df_register df_subscribe kill_agent save_agent stopMAS",
    ).flatMap { (nature, names) -> wordsOf(names).map { "$ACTIONS$it" to nature } }.toMap()

    private val functions: Map<String, Nature> = mapOf(
        Nature.PURE to """
            Abs Average Count Length Max Min Round RuleToFunction Sqrt StdDev Sum acos asin atan ceil cos e floor log mean median pi sin
            tan
        """,
        Nature.INPUT to "Random time",
    ).flatMap { (nature, names) -> wordsOf(names).map { "$FUNCTIONS$it" to nature } }.toMap()

    /** Returns the nature of the class called [type]; null if it is not known. */
    fun natureOf(type: String): Nature? = actions[type] ?: functions[type]

    fun natureOf(type: Class<*>): Nature? = natureOf(typeOf(type).name)

    /** Returns the class of Jason that [type] replaces, or [type] itself if it replaces none. */
    fun typeOf(type: Class<*>): Class<*> = if (OfInfrastructure::class.java.isAssignableFrom(type)) type.superclass else type

    /** Returns true if a replay takes the recorded result of code of this [nature]. */
    fun isRecorded(nature: Nature) = nature == Nature.INPUT || nature == Nature.EFFECT

    fun nameOf(type: String): String = if (type.startsWith(ACTIONS)) ".${type.removePrefix(ACTIONS)}" else type

    /** Returns true if the class [type] belongs to Jason or ARGO, not to a project. */
    fun isOwn(type: Class<*>): Boolean = typeOf(type).packageName.let { it == "argo" || it.startsWith("jason.") }

    /** Returns true if [code], an action or a function, belongs to Jason but is not in the table. */
    fun isUnknown(code: Any): Boolean = typeOf(code.javaClass).packageName.startsWith("jason.") && natureOf(code.javaClass) == null

    fun nameOf(code: Any): String = if (code is ArithFunction) code.name else nameOf(typeOf(code.javaClass).name)

    private fun wordsOf(names: String) = names.trim().split(Regex("\\s+"))
}
