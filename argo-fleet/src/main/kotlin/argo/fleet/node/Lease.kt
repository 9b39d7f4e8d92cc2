package argo.fleet.node

/**
 * The right to run one agent that outlives its computer, as one computer sees it: what it has promised to others, and what it has been
 * promised. The computer that runs the agent asks all for it again and again. A computer that grants it promises to grant it to no other
 * for [DURATION_NS]; the claimant counts that time from when it asked, so its right ends before the promise does. It may run the agent
 * while more than half of the computers have granted it. Two such sets have a computer in common, so two computers never run the agent at a
 * time.
 *
 * Not safe for use by several threads, except for [mayRun] and [ownTerm].
 *
 * @param computers the number of computers of the fleet
 * @param startNs when this program began: it does not know what the one before has promised, and grants nothing for one duration
 * @param claims a random number, from which claims are counted: an answer to the program before is none to this one
 * @param nanos a clock in ns that never goes back
 */
internal class Lease(private val computers: Int, startNs: Long, private var claims: Long, private val nanos: () -> Long) {
    private var promisedTo: String? = null
    private var promisedUntil = startNs + DURATION_NS
    private val asked = HashMap<Long, Long>() // the numbers of claims, with the times of their sending
    private val granted = HashMap<String, Long>() // the ends of the rights that computers have granted

    /** The greatest term that this computer knows. A new reign over the agent has a greater one than all before. */
    var term = 0L
        private set

    /** The term of this computer's reign; 0: it claims none. */
    @Volatile
    var ownTerm = 0L
        private set

    @Volatile
    private var endsNs = startNs

    /** Whether this computer may run the agent now. Any thread. */
    fun mayRun(): Boolean = endsNs - nanos() > 0

    /** Makes the next claim, to be sent to all computers in touch, this one among them. */
    fun claim(agent: String): Claim {
        if (ownTerm == 0L) ownTerm = term + 1
        val now = nanos()
        asked.values.removeIf { now - it > DURATION_NS }
        claims++
        asked[claims] = now
        return Claim(agent, claims, ownTerm)
    }

    /** Gives up this computer's reign. It holds on until its rights end. */
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
        val askedNs = asked[grant.number] ?: return
        if (grant.isGranted && grant.term == ownTerm) {
            granted[computer] = maxOf(granted[computer] ?: Long.MIN_VALUE, askedNs + DURATION_NS - MARGIN_NS)
            val majority = computers / 2 + 1
            if (granted.size >= majority) endsNs = granted.values.sortedDescending()[majority - 1]
        } else if (grant.term > term) {
            term = grant.term
            ownTerm = 0
        }
    }

    companion object {
        /** For how long a computer grants the right: it bounds how long an agent is missing, and how much a clock may jump. */
        const val DURATION_NS = 1_500_000_000L

        /** What the clocks of two computers may differ by in that time. */
        private const val MARGIN_NS = 100_000_000L
    }
}
