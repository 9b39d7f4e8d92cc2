package argo.fleet.node

/**
 * The right to run an agent that outlives its computer, as one computer knows it: the promises that it has given and received. The computer
 * that runs the agent repeatedly claims the right from all computers. A computer that grants a claim promises to grant no other computer's
 * claim for [DURATION_NS]. The claimant counts that time from its claim. The right of the claimant therefore ends before the promise does.
 * A computer may run the agent while promises of more than half of the computers are valid. Two majorities always share a computer, so the
 * agent never runs on two computers at once.
 *
 * Not safe for use by several threads, except for [mayRun] and [ownTerm].
 *
 * @param computers the number of computers of the fleet
 * @param startNs the start time of this program. The program grants nothing for [DURATION_NS] after its start, since its previous run may
 * have given a promise
 * @param claims a random first number for claims. Answers to the program's previous run then do not count
 * @param nanos a clock in ns that never goes back, but may stop while the computer is suspended
 * @param wallMs a clock in ms that also runs while the computer is suspended. Either clock can end a right, so a change of this clock may
 * end it early
 */
internal class Lease(
    private val computers: Int,
    startNs: Long,
    private var claims: Long,
    private val nanos: () -> Long,
    private val wallMs: () -> Long,
) {
    private class Moment(val ns: Long, val wallMs: Long)

    private var lastTerm = 0L // the term of this computer's last claims
    private var promisedTo: String? = null
    private var promisedUntil = startNs + DURATION_NS
    private val asked = HashMap<Long, Moment>() // the time of each claim, by the claim's number
    private val granted = HashMap<String, Moment>() // the time of the newest granted claim, by the granting computer

    /**
     * The greatest known term. A reign is the time of the agent on one computer. Each new reign has a greater term than all earlier ones.
     */
    var term = 0L
        private set

    /** The term of the reign that this computer has or claims, or 0 for none. */
    @Volatile
    var ownTerm = 0L
        private set

    /** The time of the newest claim that more than half of the computers have granted, or null for none. */
    @Volatile
    private var right: Moment? = null

    /** True if this computer may run the agent now. Safe for use by several threads. */
    fun mayRun(): Boolean {
        val since = right ?: return false
        return nanos() - since.ns < RIGHT_NS && wallMs() - since.wallMs < RIGHT_NS / NANOS_PER_MS
    }

    /** Returns the next claim. The claim must be sent to all computers in touch, including this one. */
    fun claim(agent: String): Claim {
        if (ownTerm == 0L) beginTerm()
        val now = nanos()
        asked.values.removeIf { now - it.ns > DURATION_NS }
        claims++
        asked[claims] = Moment(now, wallMs())
        return Claim(agent, claims, ownTerm)
    }

    /**
     * Starts a new term, even if this computer has not granted its own last claims, for example shortly after its start. Grants of an
     * earlier term do not count, since another computer may start that term, too.
     */
    private fun beginTerm() {
        lastTerm = maxOf(term, lastTerm) + 1
        ownTerm = lastTerm
        granted.clear()
        right = null
    }

    /** Gives up this computer's reign. */
    fun giveUp() {
        ownTerm = 0
    }

    /** Answers the [claim] of [computer]. */
    fun answer(computer: String, claim: Claim): Grant {
        val isFree = promisedTo == computer || nanos() - promisedUntil >= 0
        val isGranted = isFree && (claim.term > term || claim.term == term && promisedTo == computer)
        if (isGranted) {
            promisedTo = computer
            promisedUntil = nanos() + DURATION_NS
            term = claim.term
        }
        return Grant(claim.agent, claim.number, term, isGranted)
    }

    /** Takes the answer of [computer] to a claim. */
    fun take(computer: String, grant: Grant) {
        val moment = asked[grant.number] ?: return
        if (grant.isGranted && grant.term == ownTerm) {
            granted.merge(computer, moment) { known, new -> if (new.ns > known.ns) new else known }
            right = granted.values.sortedByDescending { it.ns }.getOrNull(computers / 2) // the newest claim that a majority has granted
        } else if (grant.term > ownTerm || !grant.isGranted && grant.term == ownTerm && !mayRun()) {
            // a computer that refuses this term has granted it to another computer, since it grants each term only once. this computer may
            // have granted a greater term meanwhile, and then `term` stays
            term = maxOf(term, grant.term)
            ownTerm = 0
        }
    }

    companion object {
        /**
         * The time for which a computer grants the right. After a loss, the agent may be missing for this time. No clock may jump by more
         * than this.
         */
        const val DURATION_NS = 1_500_000_000L

        /** The time for which the claimant uses the right. The time is shorter than the promise, since clocks may differ a little. */
        private const val RIGHT_NS = 1_400_000_000L
        private const val NANOS_PER_MS = 1_000_000L
    }
}
