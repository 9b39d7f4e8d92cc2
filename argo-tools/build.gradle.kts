plugins { `java-library` }

dependencies {
    implementation(project(":javino-java"))
    implementation(project(":argo-filters-dsl"))
    implementation(project(":argo-recording"))
    implementation(libs.picocli)
    implementation(libs.serialization.json)
    testImplementation(project(":argo-testkit")) // tests record agents and replay them
    testImplementation(libs.jason)
}
